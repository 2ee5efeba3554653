// SPDX-License-Identifier: MIT
// One test for each hard case (result.h): the ordinary ones, or those that take minutes.
#include "hard/result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <ostream>

namespace dsc::hard {

/// What CTest calls a case.
inline void PrintTo(const HardCase& one, std::ostream* out) { *out << one.name; }

} // namespace dsc::hard

namespace dsc::hard_test {
namespace {

std::vector<hard::HardCase> cases() {
    std::vector<hard::HardCase> some;
    std::ranges::copy_if(hard::all_cases(), std::back_inserter(some),
                         [](const auto& one) { return one.is_long == DSC_LONG_CASES; });
    return some;
}

// GoogleTest takes letters, digits and underscores only; the minus of an exponent is a word.
std::string test_name(const testing::TestParamInfo<hard::HardCase>& info) {
    std::string name;
    for (const char c : info.param.name) {
        const std::size_t end = name.size();
        const bool is_exponent = c == '-' && end > 1 &&
                                 (name[end - 1] == 'e' || name[end - 1] == '_') &&
                                 std::isdigit(static_cast<unsigned char>(name[end - 2])) != 0;
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? std::string(1, c)
                : is_exponent                                    ? "minus"
                                                                 : "_";
    }
    return name;
}

class Hard : public testing::TestWithParam<hard::HardCase> {};

TEST_P(Hard, Holds) {
    const hard::HardResult result = GetParam().run();
    for (const std::string& failure : result.failures) {
        ADD_FAILURE() << result.asked << ": " << failure;
    }
    EXPECT_FALSE(result.asked.empty());
    EXPECT_FALSE(result.happened.empty());
}

INSTANTIATE_TEST_SUITE_P(Cases, Hard, testing::ValuesIn(cases()), test_name);

} // namespace
} // namespace dsc::hard_test
