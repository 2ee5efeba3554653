// SPDX-License-Identifier: MIT
// Common parts of the tests of the driver: options, and conditions that must hold after every step.
#pragma once

#include "dsc/algorithm/simulation.h"

#include "support/pointwise.h"
#include "support/random/scene.h"

#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

namespace dsc::test {

inline constexpr double coarse = 0.05;

template <class Real>
Options<Real> options_for(double h) {
    Options<Real> options;
    options.edge_length = static_cast<Real>(h);
    return options;
}

template <class Real>
void expect_sound(const Complex<Real>& complex, const Simulation<Real>& simulation) {
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
}

} // namespace dsc::test
