// SPDX-License-Identifier: MIT
// Distances between points, and from a point to a segment.
#pragma once

#include "dsc/base/types.h"

#include <algorithm>
#include <cmath>

namespace dsc {

/// The distance between two points; thesis, equation 1 for a vertex and its destination, equation 2
/// for an edge.
template <class Real>
[[nodiscard]] Real distance(const Point<Real>& a, const Point<Real>& b) {
    const Real x = b.x() - a.x();
    const Real y = b.y() - a.y();
    return std::sqrt(x * x + y * y);
}

/// The squared distance between two points.
template <class Real>
[[nodiscard]] Real squared_distance(const Point<Real>& a, const Point<Real>& b) {
    const Real x = b.x() - a.x();
    const Real y = b.y() - a.y();
    return x * x + y * y;
}

/// The middle of a and b; the thesis's ComputeMidpoint.
template <class Real>
[[nodiscard]] Point<Real> midpoint(const Point<Real>& a, const Point<Real>& b) {
    return Point<Real>(Real(0.5) * (a.x() + b.x()), Real(0.5) * (a.y() + b.y()));
}

/// Where on the segment from a (0) to b (1) the point nearest to p lies; 0 where a is b.
template <class Real>
[[nodiscard]] Real nearest_fraction(const Point<Real>& p, const Point<Real>& a,
                                    const Point<Real>& b) {
    const Point<Real> along = b - a;
    const Real square = along.squaredNorm();
    return square > 0 ? std::clamp((p - a).dot(along) / square, Real(0), Real(1)) : Real(0);
}

/// The point of the segment from a to b that is nearest to p.
template <class Real>
[[nodiscard]] Point<Real> nearest_point(const Point<Real>& p, const Point<Real>& a,
                                        const Point<Real>& b) {
    const Real fraction = nearest_fraction<Real>(p, a, b);
    return {a.x() + fraction * (b.x() - a.x()), a.y() + fraction * (b.y() - a.y())};
}

/// The squared distance from p to the segment from a to b. Computed relative to a, and so more
/// exact far from the origin than the distance to `nearest_point`, whose coordinates are rounded.
template <class Real>
[[nodiscard]] Real squared_distance(const Point<Real>& p, const Point<Real>& a,
                                    const Point<Real>& b) {
    const Point<Real> along = b - a;
    return (p - a - nearest_fraction<Real>(p, a, b) * along).squaredNorm();
}

/// The distance from p to the segment from a to b. Beside the segment it is a cross product, which
/// keeps its digits where p is very near to the line; the difference of two vectors, as in
/// `squared_distance`, cancels there.
template <class Real>
[[nodiscard]] Real distance(const Point<Real>& p, const Point<Real>& a, const Point<Real>& b) {
    const Real dx = b.x() - a.x();
    const Real dy = b.y() - a.y();
    const Real px = p.x() - a.x();
    const Real py = p.y() - a.y();
    const Real dot = dx * px + dy * py;
    const Real square = dx * dx + dy * dy;
    if (dot <= 0) {
        return std::sqrt(px * px + py * py);
    }
    if (dot >= square) {
        return distance<Real>(b, p);
    }
    return std::abs(dx * py - dy * px) / std::sqrt(square);
}

} // namespace dsc
