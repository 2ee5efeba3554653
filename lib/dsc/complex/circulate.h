// SPDX-License-Identifier: MIT
// Circulation: from triangle to triangle about a vertex, from edge to edge along a curve, and the
// summary of a star that guards need. Works for any degree; the star is not gathered.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/submesh.h"

namespace dsc {

/// Whether the edge opposite to the corner separates two phases, or lies on the domain boundary.
template <class Real>
[[nodiscard]] bool is_constrained(const Complex<Real>& complex, Corner corner) {
    return complex.phase_at(corner) != complex.phase_at(complex.twin(corner));
}

/// The corner at the same vertex in the next triangle, counter-clockwise. `border_corner` where the
/// domain ends. O(1).
template <class Real>
[[nodiscard, gnu::always_inline]] inline Corner corner_ccw(const Complex<Real>& complex, Corner c) {
    const Corner across = complex.twin(next(c));
    return is_border(across) ? border_corner : next(across);
}

/// The same, clockwise. O(1).
template <class Real>
[[nodiscard, gnu::always_inline]] inline Corner corner_cw(const Complex<Real>& complex, Corner c) {
    const Corner across = complex.twin(prev(c));
    return is_border(across) ? border_corner : prev(across);
}

/// The corner from which to visit all triangles about the vertex of `start` counter-clockwise: at a
/// vertex of the domain boundary the corner at the clockwise end, elsewhere `start`. O(degree).
template <class Real>
[[nodiscard]] Corner first_corner(const Complex<Real>& complex, Corner start) {
    Corner first = start;
    while (true) {
        const Corner c = corner_cw(complex, first);
        if (is_border(c)) {
            return first;
        }
        if (c == start) {
            return start;
        }
        first = c;
    }
}

/// Calls `visit(corner)` counter-clockwise from `first` on, until the domain ends or `first` is
/// reached again, and returns the last corner visited. O(degree).
template <class Real, class Visit>
Corner circulate(const Complex<Real>& complex, Corner first, Visit visit) {
    Corner c = first;
    while (true) {
        visit(c);
        const Corner following = corner_ccw(complex, c);
        if (is_border(following) || following == first) {
            return c;
        }
        c = following;
    }
}

/// Calls `visit(corner)` for each corner at `v`: counter-clockwise, and at a vertex of the domain
/// boundary from its first triangle to its last. O(degree), no allocation.
template <class Real, class Visit>
void for_each_corner(const Complex<Real>& complex, Vertex v, Visit visit) {
    const Corner start = complex.vertices[v.id].corner;
    if (start != no_id) {
        circulate(complex, first_corner(complex, start), visit);
    }
}

/// A corner at `v` for which `test(corner)` holds, or no_id. Corners are tested in no particular
/// order, each once; the search ends with the first that passes. O(degree).
template <class Real, class Test>
[[nodiscard]] Corner find_corner(const Complex<Real>& complex, Vertex v, Test test) {
    const Corner start = complex.vertices[v.id].corner;
    if (start == no_id) {
        return no_id;
    }
    Corner c = start;
    do {
        if (test(c)) {
            return c;
        }
        c = corner_ccw(complex, c);
    } while (!is_border(c) && c != start);
    if (c == start) {
        return no_id;
    }
    // The domain ends here: continue clockwise from the start.
    for (c = corner_cw(complex, start); !is_border(c); c = corner_cw(complex, c)) {
        if (test(c)) {
            return c;
        }
    }
    return no_id;
}

/// A half-edge is named by the corner opposite to it and runs from next(c) to prev(c), with its
/// triangle on the left. Turns clockwise from `c` about the end of its half-edge, to the next
/// half-edge that leaves that end and for which `is_edge(corner)` holds. This is one step along the
/// boundary of a region if `is_edge` holds for the half-edges that have the region on their left
/// and not on their right. Every half-edge of the domain boundary on the way must pass the test.
/// O(degree).
template <class Real, class IsEdge>
[[nodiscard]] Corner next_along(const Complex<Real>& complex, Corner c, IsEdge is_edge) {
    c = next(c);
    while (!is_edge(c)) {
        c = next(complex.twin(c));
    }
    return c;
}

/// The step in the other direction, to the previous half-edge, which ends where the half-edge of
/// `c` begins. O(degree).
template <class Real, class IsEdge>
[[nodiscard]] Corner previous_along(const Complex<Real>& complex, Corner c, IsEdge is_edge) {
    c = prev(c);
    while (!is_edge(c)) {
        c = prev(complex.twin(c));
    }
    return c;
}

/// The summary of a star: whether the vertex is on the domain boundary, whether the submesh owns
/// the whole star, and how many interface edges meet at the vertex.
struct StarSummary {
    bool on_boundary = false;          ///< the domain ends at the vertex
    bool owned = true;                 ///< every triangle of the star is in the submesh
    std::uint32_t interface_edges = 0; ///< that meet at the vertex
    std::uint32_t first = no_id;       ///< if on_boundary: the neighbour at the clockwise end
    std::uint32_t last = no_id;        ///< if on_boundary: the neighbour at the other end
};

/// Calls `visit(corner at the vertex)` for each star triangle, counter-clockwise; on the domain
/// boundary from the clockwise end. Fills in `on_boundary`, `first` and `last`. O(degree).
template <class Real, class Visit>
StarSummary turn(const Complex<Real>& complex, std::uint32_t vertex, Visit visit) {
    StarSummary summary;
    const Corner start = complex.vertices[vertex].corner;
    if (start == no_id) {
        return summary;
    }
    const Corner first = first_corner(complex, start);
    summary.on_boundary = is_border(complex.twin(prev(first)));
    const Corner last = circulate(complex, first, visit);
    if (summary.on_boundary) {
        summary.first = complex.vertex(next(first));
        summary.last = complex.vertex(prev(last));
    }
    return summary;
}

/// Calls `visit(vertex at the other end)` for each interface edge at the vertex. O(degree).
template <class Real, class Visit>
StarSummary for_each_interface_edge(const Complex<Real>& complex, std::uint32_t vertex,
                                    Visit visit) {
    return turn(complex, vertex, [&](Corner c) {
        // Visits each incident edge once: the clockwise one of each triangle, and the last one of
        // an open star.
        const Corner cw = complex.twin(prev(c));
        if (is_interface_pair(complex.phase_at(c), complex.phase_at(cw))) {
            visit(complex.vertex(next(c)));
        }
        const Corner ccw = complex.twin(next(c));
        if (is_border(ccw) && is_interface_pair(complex.phase_at(c), border_phase)) {
            visit(complex.vertex(prev(c)));
        }
    });
}

/// The whole summary. The region must own the vertex: another submesh may be rewriting a foreign
/// star at this moment. O(degree).
template <class Real>
StarSummary inspect(const Complex<Real>& complex, const Region& region, std::uint32_t vertex) {
    std::uint32_t interface_edges = 0;
    StarSummary summary =
        for_each_interface_edge(complex, vertex, [&](std::uint32_t) { ++interface_edges; });
    summary.interface_edges = interface_edges;
    if (!region.is_whole()) {
        turn(complex, vertex, [&](Corner c) {
            summary.owned = summary.owned && owns_triangle(complex, region, triangle_of(c));
        });
    }
    return summary;
}

} // namespace dsc
