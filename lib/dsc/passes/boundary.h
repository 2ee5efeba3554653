// SPDX-License-Identifier: MIT
// Remeshing along the domain boundary (thesis, section 8.3). Where an interface slides along a
// boundary, the domain boundary's edges ahead of it become short and those behind it long: vertices
// inside one phase are collapsed along the domain boundary, and edges are split at their midpoints,
// so that the domain keeps its shape. Boundaries of the exterior phase belong to the mesh update,
// those of any other phase to the interface (figure 8.3) and its remeshing.
#pragma once

#include "dsc/base/verdict.h"
#include "dsc/geometry/side.h"
#include "dsc/passes/edits.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"

#include <algorithm>

namespace dsc {

/// The squared lengths that count as long and short along a side of the domain, and the smallest
/// quality that a collapse may leave.
template <class Real>
struct BoundaryLimits {
    Real longest = 0;
    Real shortest = 0;
    Real min_quality = 0; ///< equation 4, not squared
    /// A shorter boundary edge blocks the interface that moves along it. It is collapsed even if
    /// the merged edge is too long and split again: as a length, at most half of `longest`.
    Real blocking = 0;
};

/// One of the two incident edges of an open star that lie on the domain boundary.
template <class Real>
struct BoundaryEdge {
    std::uint32_t link = 0; ///< index in the star
    Corner corner = 0;      ///< opposite to the edge
    rewire::Vanishing end;  ///< the end at which the centre is
    Real squared = 0;       ///< length
};

/// The incident edge with the domain on its left, seen from the centre, or the other one. The star
/// must be open.
template <class Real>
BoundaryEdge<Real> boundary_edge(const Star<Real>& star, bool is_first) {
    BoundaryEdge<Real> incident_edge;
    incident_edge.link = is_first ? 0 : star.size;
    incident_edge.corner = is_first ? prev(star.corner[0]) : next(star.corner[star.size - 1]);
    incident_edge.end = is_first ? rewire::Vanishing::next : rewire::Vanishing::prev;
    incident_edge.squared = star.squared_edge(incident_edge.link);
    return incident_edge;
}

/// The squared length of the merged edge on the domain boundary if the centre is collapsed.
template <class Real>
Real merged_on_boundary(const Star<Real>& star) {
    const Real dx = star.link_x(star.size) - star.link_x(0);
    const Real dy = star.link_y(star.size) - star.link_y(0);
    return dx * dx + dy * dy;
}

/// Whether the centre, a vertex of the domain boundary inside one phase, should be collapsed:
/// because a boundary edge there is short, or because its star is poor. On a curved side shortness
/// is a reason only if the edge blocks a vertex that slides there, because each collapse changes
/// the shape of the domain slightly.
template <class Real>
bool should_collapse_on_boundary(const Complex<Real>& complex, const Star<Real>& star,
                                 const BoundaryLimits<Real>& limits, bool is_poor = false) {
    if (star.closed || !star.one_phase || complex.is_boundary_feature(Vertex{star.vertex})) {
        return false;
    }
    const Real shorter =
        std::min(boundary_edge(star, true).squared, boundary_edge(star, false).squared);
    const auto is_straight = [&] {
        return side_at<Real>({star.link_x(0), star.link_y(0)}, {star.x0, star.y0},
                             {star.link_x(star.size), star.link_y(star.size)},
                             false) == Side::straight;
    };
    const bool is_short = shorter < limits.shortest;
    return shorter < limits.blocking ||
           (merged_on_boundary(star) < limits.longest && (is_poor || (is_short && is_straight())));
}

/// Whether the boundary edge with the domain on its left, seen from the centre, or the other one,
/// is too long. With uniform limits the first suffices, since each edge is the first one at one of
/// its ends; otherwise an edge is too long if it is so at either end.
template <class Real>
bool should_split_boundary(const Star<Real>& star, const BoundaryLimits<Real>& limits,
                           bool is_first = true) {
    return !star.closed && boundary_edge(star, is_first).squared > limits.longest;
}

/// The worst quality of the centre's triangles after a collapse into link vertex i, a neighbour on
/// the domain boundary. O(degree).
template <class Real>
Real quality_after_boundary_collapse(const Star<Real>& star, std::uint32_t i) {
    const Point<Real> target(star.link_x(i), star.link_y(i));
    Real worst = 1;
    for (std::uint32_t j = i == 0 ? 1 : 0; j < (i == 0 ? star.size : star.size - 1); ++j) {
        worst = std::min(
            worst, quality<Real>(target, {star.x[j], star.y[j]}, {star.x_next[j], star.y_next[j]}));
    }
    return worst;
}

/// Collapses the centre into the neighbour on the domain boundary that leaves the better triangles,
/// if they are not below `min_quality`, and activates the link. The guard keeps corners of the
/// domain.
template <class Real>
bool collapse_on_boundary(Work<Real>& work, const Star<Real>& star,
                          const BoundaryLimits<Real>& limits) {
    const Real first = quality_after_boundary_collapse(star, 0);
    const Real last = quality_after_boundary_collapse(star, star.size);
    for (const bool is_first : {first >= last, first < last}) {
        if ((is_first ? first : last) < limits.min_quality) {
            return false; // the other one is worse
        }
        const BoundaryEdge<Real> incident_edge = boundary_edge(star, is_first);
        if (collapse_centre(work, star, incident_edge.corner, incident_edge.end) ==
            Verdict::legal) {
            return true;
        }
    }
    return false;
}

/// Splits the domain boundary's edge with the domain on its left, as seen from the centre, or the
/// other one: on the curve that the side follows at the centre. The new vertex is activated.
/// After `out_of_ids` and `on_submesh_boundary` another submesh must make the split.
template <class Real>
SplitResult split_boundary(Work<Real>& work, const Star<Real>& star, bool is_first = true) {
    const BoundaryEdge<Real> incident_edge = boundary_edge(star, is_first);
    const std::uint32_t before = is_first ? star.size : 0;
    const Point<Real> middle =
        middle_of_side<Real>({star.link_x(before), star.link_y(before)}, {star.x0, star.y0},
                             {star.link_x(incident_edge.link), star.link_y(incident_edge.link)},
                             work.complex.is_boundary_feature(Vertex{star.vertex}));
    if (!owns_place(work.submesh.region, middle)) {
        return {Verdict::on_submesh_boundary, {}};
    }
    return split(work, incident_edge.corner, middle, Wake::all);
}

} // namespace dsc
