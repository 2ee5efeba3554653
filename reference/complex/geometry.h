// SPDX-License-Identifier: MIT
// Geometry used by the algorithms of the thesis: midpoints, and the orientation of a triangle after
// a move of one of its vertices.
#pragma once

#include "dsc/geometry/predicates.h"
#include "reference/complex/complex.h"

namespace dsc::reference {

/// Twice the signed area of the triangle (o, a, b).
inline double cross(const Point<double>& o, const Point<double>& a, const Point<double>& b) {
    return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

/// ComputeMidpoint of algorithms 7.4 and 7.6.
inline Point<double> compute_midpoint(const Point<double>& a, const Point<double>& b) {
    return {0.5 * (a.x() + b.x()), 0.5 * (a.y() + b.y())};
}

/// Insert, Coord and interpolation of a vertex between two others (thesis, section 8.9).
inline Vertex insert_between(Vertex a, Vertex b, const Point<double>& coord, Complex& K) {
    const Vertex m = K.insert(coord);
    if (K.interpolate) {
        K.interpolate(m, a, b);
    }
    return m;
}

/// Orientation of `t` if its vertex `v` were at `p`; nothing is moved.
inline int orientation_if(const Complex& K, const TriangleKey& t, Vertex v,
                          const Point<double>& p) {
    const OrientedTriangle& o = K.oriented(t);
    const auto at = [&](Vertex u) -> const Point<double>& { return u == v ? p : K.coord(u); };
    return dsc::orientation(at(o[0]), at(o[1]), at(o[2]));
}

} // namespace dsc::reference
