// SPDX-License-Identifier: MIT
// What the tests of the driver share: velocities from functions of a point, and the conditions that
// must hold after every step.
#pragma once

#include "dsc/algorithm/simulation.h"

#include "support/random/scene.h"

#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

namespace dsc::test {

inline constexpr double coarse = 0.05;

template <class Real>
Options<Real> options_for(double h) {
    Options<Real> options;
    options.edge_length = static_cast<Real>(h);
    return options;
}

template <class Real>
Velocity<Real> pointwise(std::function<Point<double>(const Point<double>&, double)> field) {
    return [field = std::move(field)](std::span<const Point<Real>> positions, Real time,
                                      std::span<Point<Real>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = field(positions[i].template cast<double>(), static_cast<double>(time))
                                .template cast<Real>();
        }
    };
}

template <class Real>
Velocity<Real> constant(double x, double y) {
    return pointwise<Real>([=](const Point<double>&, double) { return Point<double>(x, y); });
}

template <class Real>
void expect_sound(const Complex<Real>& complex, const Simulation<Real>& simulation) {
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_EQ(test::interface_fault(complex, simulation.interface()), "");
}

} // namespace dsc::test
