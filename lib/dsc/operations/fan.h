// SPDX-License-Identifier: MIT
// What a guard learns in one turn about a vertex: whether the domain ends there, whether the
// submesh owns the whole star, and how many interface edges meet there. Works for any degree; the
// star is not gathered.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/submesh.h"

namespace dsc {

/// What one turn about a vertex tells.
struct Fan {
    bool on_boundary = false;          ///< the domain ends at the vertex
    bool owned = true;                 ///< every triangle of the star is in the submesh
    std::uint32_t interface_edges = 0; ///< that meet at the vertex
    std::uint32_t first = no_id;       ///< if on_boundary: the neighbour at the clockwise end
    std::uint32_t last = no_id;        ///< and the one at the other end
};

/// Calls `visit(corner at the vertex)` for each star triangle, counter-clockwise; on the domain
/// boundary from the clockwise end. Fills in `on_boundary`, `first` and `last`. O(degree).
template <class Real, class Visit>
Fan turn(const Complex<Real>& complex, std::uint32_t vertex, Visit visit) {
    Fan fan;
    const Corner start = complex.vertices[vertex].corner;
    if (start == no_id) {
        return fan;
    }
    const Corner first = first_corner(complex, start);
    fan.on_boundary = is_border(complex.twin(prev(first)));
    const Corner last = circulate(complex, first, visit);
    if (fan.on_boundary) {
        fan.first = complex.vertex(next(first));
        fan.last = complex.vertex(prev(last));
    }
    return fan;
}

/// Calls `visit(vertex at the other end)` for each interface edge at the vertex. O(degree).
template <class Real, class Visit>
Fan for_each_interface_edge(const Complex<Real>& complex, std::uint32_t vertex, Visit visit) {
    return turn(complex, vertex, [&](Corner c) {
        // Each spoke once: the clockwise one of each triangle, and the last one of an open fan.
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

/// The whole Fan. The region must own the vertex: another submesh may be rewriting a foreign star
/// at this moment. O(degree).
template <class Real>
Fan inspect(const Complex<Real>& complex, const Region& region, std::uint32_t vertex) {
    std::uint32_t interface_edges = 0;
    Fan fan = for_each_interface_edge(complex, vertex, [&](std::uint32_t) { ++interface_edges; });
    fan.interface_edges = interface_edges;
    if (!region.is_whole()) {
        turn(complex, vertex, [&](Corner c) {
            fan.owned = fan.owned && owns_triangle(complex, region, triangle_of(c));
        });
    }
    return fan;
}

} // namespace dsc
