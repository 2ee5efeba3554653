// SPDX-License-Identifier: MIT
// The simplest velocity.
#pragma once

#include "dsc/motion/integrator.h"

#include <algorithm>
#include <span>

namespace dsc::test {

inline Velocity<double> everywhere(double x, double y) {
    return [=](std::span<const Point<double>>, double, std::span<Point<double>> velocities) {
        std::ranges::fill(velocities, Point<double>(x, y));
    };
}

} // namespace dsc::test
