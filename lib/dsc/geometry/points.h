// SPDX-License-Identifier: MIT
// Measures of points: distances to points and segments, the turns of a polyline, and the polynomial
// through points.
#pragma once

#include "dsc/base/types.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

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

/// The parameter, 0 at a and 1 at b, of the segment's point nearest to p; 0 where a equals b.
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

/// The distance from p to the segment from a to b. Unless an end is nearest, it is a cross product,
/// which stays accurate where p is very near to the line; the difference of two vectors, as in
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

/// The cross product of two vectors: positive where v points to the left of u.
template <class Real>
[[nodiscard]] Real cross(const Point<Real>& u, const Point<Real>& v) {
    return u.x() * v.y() - u.y() * v.x();
}

/// The angle by which the polyline turns at `at`, in radians from -pi to pi, positive to the left.
template <class Real>
[[nodiscard]] Real turn_angle(const Point<Real>& from, const Point<Real>& at,
                              const Point<Real>& to) {
    const Point<Real> in = at - from;
    const Point<Real> out = to - at;
    return std::atan2(cross<Real>(in, out), in.dot(out));
}

/// Whether the polyline turns by less than the angle of this cosine at `at`.
template <class Real>
[[nodiscard, gnu::always_inline]] inline bool
turns_less(const Point<Real>& from, const Point<Real>& at, const Point<Real>& to, Real cosine) {
    // Uses scalars, because a vector load would wait for two scalar stores if the points have just
    // been computed.
    const Real in_x = at.x() - from.x();
    const Real in_y = at.y() - from.y();
    const Real out_x = to.x() - at.x();
    const Real out_y = to.y() - at.y();
    return in_x * out_x + in_y * out_y >
           cosine * std::sqrt((in_x * in_x + in_y * in_y) * (out_x * out_x + out_y * out_y));
}

/// Whether the polyline turns by more than the angle of this cosine at `at`. Not the negation of
/// `turns_less`: both are false if an edge has length 0. Multiplies two lengths rather than taking
/// the root of a product, which would leave the range of Real for lengths of 1e-100.
template <class Real>
[[nodiscard]] bool turns_more(const Point<Real>& from, const Point<Real>& at, const Point<Real>& to,
                              double cosine) {
    const Point<Real> in = at - from;
    const Point<Real> out = to - at;
    return static_cast<double>(in.dot(out)) <
           cosine * static_cast<double>(in.norm()) * static_cast<double>(out.norm());
}

/// Curvature of the circle through three points, positive where it turns left; 0 where two of them
/// coincide. In 1 / length.
template <class Real>
[[nodiscard]] Real curvature(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    const Point<Real> in = b - a;
    const Point<Real> out = c - b;
    const Real lengths = in.norm() * out.norm() * (c - a).norm();
    return lengths > 0 ? 2 * cross<Real>(in, out) / lengths : Real(0);
}

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
