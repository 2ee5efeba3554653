// SPDX-License-Identifier: MIT
// The polynomial through points of the plane.
#pragma once

#include "dsc/base/types.h"

#include <cstddef>
#include <span>

namespace dsc {

/// The value at the parameter `at` of the Lagrange polynomial that takes the value points[i] at the
/// parameter knots[i], no two of which are equal. The sum is formed relative to `origin`, a point
/// near the result, so that an offset of the coordinates costs no digits. O(n^2).
template <class Real>
[[nodiscard]] Point<Real> lagrange(std::span<const Point<Real>> points, std::span<const Real> knots,
                                   Real at, const Point<Real>& origin) {
    Point<Real> sum = Point<Real>::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        Real weight = 1;
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (j != i) {
                weight *= (at - knots[j]) / (knots[i] - knots[j]);
            }
        }
        sum += weight * (points[i] - origin);
    }
    return origin + sum;
}

} // namespace dsc
