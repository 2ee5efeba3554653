// SPDX-License-Identifier: MIT
// How a polyline turns at one of its vertices.
#pragma once

#include "dsc/base/types.h"

#include <cmath>

namespace dsc {

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
    // In scalars: a vector load waits for two scalar stores, if the points have just been made.
    const Real in_x = at.x() - from.x();
    const Real in_y = at.y() - from.y();
    const Real out_x = to.x() - at.x();
    const Real out_y = to.y() - at.y();
    return in_x * out_x + in_y * out_y >
           cosine * std::sqrt((in_x * in_x + in_y * in_y) * (out_x * out_x + out_y * out_y));
}

/// Whether the polyline turns by more than the angle of this cosine at `at`. Not the negation of
/// `turns_less`: a polyline with an edge of no length does neither. Multiplies two lengths rather
/// than taking the root of a product, which would leave the range of Real for lengths of 1e-100.
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

} // namespace dsc
