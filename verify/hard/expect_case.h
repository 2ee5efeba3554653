// SPDX-License-Identifier: MIT
// One test for each hard case.
#pragma once

#include "result.h"

#include <gtest/gtest.h>

#include <cctype>
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

/// GoogleTest takes letters, digits and underscores only; a minus before a digit is "minus".
inline std::string test_name(const testing::TestParamInfo<HardCase>& info) {
    std::string name;
    for (const char c : info.param.name) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
            name += c;
        } else {
            const bool is_sign = c == '-' && !name.empty() &&
                                 (name.back() == 'e' || name.back() == '_') &&
                                 info.param.name.find("size") == 0;
            name += is_sign ? "minus" : "_";
        }
    }
    return name;
}

inline void expect_case(const HardCase& one) {
    const HardResult result = one.run();
    for (const std::string& failure : result.failures) {
        ADD_FAILURE() << one.name << " (" << result.asked << "): " << failure;
    }
    EXPECT_FALSE(result.asked.empty());
    EXPECT_FALSE(result.happened.empty());
}

} // namespace dsc::hard
