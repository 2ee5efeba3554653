// SPDX-License-Identifier: MIT
// Exact signs. A static filter answers nearly always; Boost.Multiprecision answers the rest.
// J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates" (1997), gives the error bounds of the filters.
#pragma once

#include "dsc/base/types.h"

#include <cmath>

namespace dsc {

namespace exact {
/// Sign of the doubled area of (a, b, c), computed in rational arithmetic; 0 for non-finite input.
int orientation(double ax, double ay, double bx, double by, double cx, double cy);
/// Sign of the in-circle determinant in rational arithmetic; 0 for non-finite input.
int in_circle(double ax, double ay, double bx, double by, double cx, double cy, double dx,
              double dy);
} // namespace exact

/// (3 + 16 eps) eps with eps = 2^-53: a determinant above this times |l| + |r| has a certain sign.
inline constexpr double orientation_bound = 3.3306690738754716e-16;
/// Products below this may have lost bits to underflow, which the bound does not cover.
inline constexpr double underflow_guard = 1e-280;

/// +1 if (a, b, c) turns counter-clockwise, -1 if clockwise, 0 if collinear (or not finite).
/// Exact for every finite input. Thread-safe. Thesis 4.1: `Orientation`.
inline int orientation(double ax, double ay, double bx, double by, double cx, double cy) {
    const double left = (bx - ax) * (cy - ay);
    const double right = (by - ay) * (cx - ax);
    const double det = left - right;
    const double size = std::abs(left) + std::abs(right);
    if (std::abs(det) > orientation_bound * size && size > underflow_guard) {
        return det > 0 ? 1 : -1;
    }
    return exact::orientation(ax, ay, bx, by, cx, cy);
}

template <class Real>
int orientation(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    return orientation(static_cast<double>(a.x()), static_cast<double>(a.y()),
                       static_cast<double>(b.x()), static_cast<double>(b.y()),
                       static_cast<double>(c.x()), static_cast<double>(c.y()));
}

/// +1 if d lies inside the circle through the counter-clockwise (a, b, c), -1 outside, 0 on it.
/// Exact for every finite input. Thread-safe.
int in_circle(double ax, double ay, double bx, double by, double cx, double cy, double dx,
              double dy);

template <class Real>
int in_circle(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c,
              const Point<Real>& d) {
    return in_circle(static_cast<double>(a.x()), static_cast<double>(a.y()),
                     static_cast<double>(b.x()), static_cast<double>(b.y()),
                     static_cast<double>(c.x()), static_cast<double>(c.y()),
                     static_cast<double>(d.x()), static_cast<double>(d.y()));
}

} // namespace dsc
