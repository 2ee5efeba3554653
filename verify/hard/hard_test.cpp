// SPDX-License-Identifier: MIT
// One test for each hard case (result.h): either the ordinary ones, or those that take minutes.
#include "hard/result.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <ostream>
#include <regex>

namespace dsc::hard {

/// The name of a case in CTest.
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

// GoogleTest's names may have only letters, digits and underscores, so the minus of an exponent
// becomes a word.
std::string test_name(const testing::TestParamInfo<hard::HardCase>& info) {
    const std::regex exponent("(\\d[e^])-");
    const std::string name = std::regex_replace(info.param.name, exponent, "$1minus");
    return std::regex_replace(name, std::regex("[^A-Za-z0-9]"), "_");
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
