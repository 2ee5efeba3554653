// SPDX-License-Identifier: MIT
// The Delaunay condition of one edge (thesis, section 4.2), without square roots: the angles
// opposite to it add up to at most pi, up to a slack that keeps cocircular points from flipping
// back and forth. `in_circle` and `certainly_in_circle` of predicates.h test the same condition
// without slack.
#pragma once

#include "dsc/base/tolerances.h"
#include "dsc/base/types.h"

#include <cmath>

namespace dsc {

/// The sine of the sum of the two angles opposite to an edge, plus the slack: the edge is Delaunay
/// where it is not negative. The angles are given by multiples of their sine and cosine (a cross
/// and a dot product of the edges there).
template <class Real>
[[nodiscard]] Real delaunay_margin(Real sine_a, Real cosine_a, Real sine_d, Real cosine_d) {
    const Real one = sine_a * cosine_d;
    const Real two = cosine_a * sine_d;
    return one + two + delaunay_slack<Real> * (std::abs(one) + std::abs(two));
}

/// Whether the edge (b, w) of the triangles (a, b, w) and (d, w, b) is Delaunay.
template <class Real>
[[nodiscard]] bool is_delaunay(const Point<Real>& a, const Point<Real>& b, const Point<Real>& d,
                               const Point<Real>& w) {
    const Real abx = b.x() - a.x();
    const Real aby = b.y() - a.y();
    const Real awx = w.x() - a.x();
    const Real awy = w.y() - a.y();
    const Real dbx = b.x() - d.x();
    const Real dby = b.y() - d.y();
    const Real dwx = w.x() - d.x();
    const Real dwy = w.y() - d.y();
    return delaunay_margin<Real>(abx * awy - aby * awx, abx * awx + aby * awy,
                                 dwx * dby - dwy * dbx, dbx * dwx + dby * dwy) >= 0;
}

} // namespace dsc
