// SPDX-License-Identifier: MIT
// One test for each hard case.
#pragma once

#include "result.h"

#include <gtest/gtest.h>

#include <cctype>
#include <ostream>
#include <string>
#include <vector>

namespace dsc::hard {

/// The ordinary cases, or the long ones.
inline std::vector<HardCase> cases_that_are(bool long_ones) {
    std::vector<HardCase> cases;
    for (const HardCase& one : all_cases()) {
        if (one.is_long == long_ones) {
            cases.push_back(one);
        }
    }
    return cases;
}

/// GoogleTest takes letters, digits and underscores only; the minus of an exponent is a word.
inline std::string test_name(const testing::TestParamInfo<HardCase>& info) {
    const std::string& given = info.param.name;
    std::string name;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto is_digit = [&](std::size_t at) {
            return at < given.size() && std::isdigit(static_cast<unsigned char>(given[at])) != 0;
        };
        const bool is_exponent =
            i > 1 && (given[i - 1] == 'e' || given[i - 1] == '^') && is_digit(i - 2);
        if (std::isalnum(static_cast<unsigned char>(given[i])) != 0) {
            name += given[i];
        } else {
            name += given[i] == '-' && is_exponent ? "minus" : "_";
        }
    }
    return name;
}

/// What CTest calls a case.
inline void PrintTo(const HardCase& one, std::ostream* out) { *out << one.name; }

inline void expect_case(const HardCase& one) {
    const HardResult result = one.run();
    for (const std::string& failure : result.failures) {
        ADD_FAILURE() << one.name << " (" << result.asked << "): " << failure;
    }
    EXPECT_FALSE(result.asked.empty());
    EXPECT_FALSE(result.happened.empty());
}

} // namespace dsc::hard
