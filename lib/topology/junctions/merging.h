// SPDX-License-Identifier: MIT
// Merges two junctions along the short edge between them.
#pragma once

#include "dsc/geometry/predicates.h"
#include "topology/region.h"

#include <algorithm>

namespace dsc {

/// Collapses the edge between two vertices into one of them, which keeps its position, and returns
/// it: `w`, or with `either` the one that leaves the better triangles. Vertices inside a phase that
/// would leave flat triangles are removed first. Returns no vertex if the triangles about the edge
/// prevent the collapse. O(degree), a few times.
template <class Real>
[[nodiscard]] Vertex merge_ends(TopologyWork<Real>& work, Vertex v, Vertex w, bool either);

/// The curves that end at a vertex sweep area as it moves, each the triangle between its first edge
/// before and after: adds it to `work.swept`, and to the transfers if area is to be given back.
/// Leaves out the edge to `kept`, which is about to vanish. O(degree).
template <class Real>
void note_sweep(TopologyWork<Real>& work, Vertex gone, Vertex kept, const Point<Real>& to);

/// Collapses a vertex inside a phase into the neighbour that leaves the best triangles. Returns
/// false if no collapse leaves a squared quality above `min_quality`. O(degree squared).
template <class Real>
bool remove_inside(TopologyWork<Real>& work, Vertex vertex, Real min_quality);

/// Collapses a vertex of the domain boundary, with one phase around it, along the boundary. Returns
/// false if that is illegal, or would leave a triangle whose squared quality is not above
/// `min_quality`, or a long edge on the boundary. O(degree).
template <class Real>
bool remove_on_boundary(TopologyWork<Real>& work, Vertex vertex, Real min_quality);

/// Height of a triangle over its longest edge; 0 if it is not positive.
template <class Real>
[[nodiscard]] Real height_over_longest(const Point<Real>& p, const Point<Real>& a,
                                       const Point<Real>& b) {
    const Point<Real> to_a = a - p;
    const Point<Real> to_b = b - p;
    return orientation<Real>(p, a, b) > 0
               ? cross<Real>(to_a, to_b) /
                     std::max({(to_b - to_a).squaredNorm(), to_a.squaredNorm(), to_b.squaredNorm()})
               : Real(0);
}

/// The smallest of these in the star of a vertex, with the vertex at a place. O(degree).
template <class Real>
[[nodiscard]] Real worst_height(const Complex<Real>& complex, Vertex v, const Point<Real>& place) {
    Real worst = 1;
    for_each_corner(complex, v, [&](Corner c) {
        worst = std::min(worst, height_over_longest<Real>(
                                    place, complex.position(Vertex{complex.vertex(next(c))}),
                                    complex.position(Vertex{complex.vertex(prev(c))})));
    });
    return worst;
}

} // namespace dsc
