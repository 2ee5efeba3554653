// SPDX-License-Identifier: MIT
// The Delaunay condition of one edge [4.2], without square roots: the angles opposite to it add up
// to at most pi, up to a slack that keeps cocircular points from flipping back and forth.
#pragma once

#include "dsc/base/tolerances.h"
#include "dsc/complex/complex.h"

#include <cmath>

namespace dsc {

/// The sine of the sum of the angles at a and d, opposite to the edge (b, w), is not below the
/// slack.
template <class Real>
bool is_delaunay(const Point<Real>& a, const Point<Real>& b, const Point<Real>& d,
                 const Point<Real>& w) {
    const Real abx = b.x() - a.x();
    const Real aby = b.y() - a.y();
    const Real awx = w.x() - a.x();
    const Real awy = w.y() - a.y();
    const Real dbx = b.x() - d.x();
    const Real dby = b.y() - d.y();
    const Real dwx = w.x() - d.x();
    const Real dwy = w.y() - d.y();
    const Real sine_a = abx * awy - aby * awx;
    const Real cosine_a = abx * awx + aby * awy;
    const Real sine_d = dwx * dby - dwy * dbx;
    const Real cosine_d = dbx * dwx + dby * dwy;
    const Real one = sine_a * cosine_d;
    const Real two = cosine_a * sine_d;
    return one + two + delaunay_slack<Real> * (std::abs(one) + std::abs(two)) >= 0;
}

/// The same for the edge opposite to `corner`, which must have two triangles.
template <class Real>
bool is_delaunay(const Complex<Real>& complex, Corner corner) {
    return is_delaunay<Real>(complex.position(Vertex{complex.vertex(corner)}),
                             complex.position(Vertex{complex.vertex(next(corner))}),
                             complex.position(Vertex{complex.vertex(complex.twin(corner))}),
                             complex.position(Vertex{complex.vertex(prev(corner))}));
}

} // namespace dsc
