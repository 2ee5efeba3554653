// SPDX-License-Identifier: MIT
// Velocities from functions of a point, and optionally of the time.
#pragma once

#include "dsc/motion/integrator.h"

#include <span>
#include <type_traits>
#include <utility>

namespace dsc::test {

/// From a function of a Point<double>, or of a point and the time, that returns a Point<double>.
template <class Real = double, class Field>
Velocity<Real> pointwise(Field field) {
    return [field = std::move(field)](std::span<const Point<Real>> positions, Real time,
                                      std::span<Point<Real>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Point<double> p = positions[i].template cast<double>();
            Point<double> velocity;
            if constexpr (std::is_invocable_v<const Field&, const Point<double>&>) {
                velocity = field(p);
            } else {
                velocity = field(p, static_cast<double>(time));
            }
            velocities[i] = velocity.template cast<Real>();
        }
    };
}

/// A constant velocity.
template <class Real = double>
Velocity<Real> constant(double x, double y) {
    return pointwise<Real>([=](const Point<double>&) { return Point<double>(x, y); });
}

} // namespace dsc::test
