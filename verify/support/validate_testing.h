// SPDX-License-Identifier: MIT
#pragma once

#include "dsc/base/error.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <string>

namespace dsc::test {

/// Checks that the validator finds a problem whose message contains these words.
template <class Real>
void expect_problem(const Complex<Real>& complex, const std::string& words) {
    const ValidationReport report = validate(complex);
    EXPECT_FALSE(report.ok()) << "not found: " << words;
    EXPECT_NE(report.problem.find(words), std::string::npos)
        << "expected: " << words << "\nreported: " << report.problem;
    EXPECT_THROW(validate_or_throw(complex), InvariantError);
}

} // namespace dsc::test
