// SPDX-License-Identifier: MIT
// Edge collapse (thesis, sections 4.2 and 7.5): an edge shrinks to one of its ends.
#pragma once

#include "dsc/base/verdict.h"
#include "dsc/complex/rewire.h"
#include "dsc/complex/ring.h"
#include "dsc/complex/submesh.h"

namespace dsc {

/// Whether a junction may be merged into another one along the interface edge between them, or the
/// end of a curve into another vertex along the domain boundary.
enum class JunctionRule : std::uint8_t { kept, may_merge };

/// Whether the vanishing end v of the edge opposite to `corner` may be merged into the other end.
/// An interface vertex may be merged along its interface, a boundary vertex along a straight
/// boundary (thesis, section 6.5). O(degree). Exact.
template <class Real>
Verdict edge_collapse_guard(const Complex<Real>& complex, const Region& region, Corner corner,
                            rewire::Vanishing end, JunctionRule junctions = JunctionRule::kept);

/// Collapses in that direction if it is legal. Thread-safe for disjoint submeshes.
template <class Real>
Verdict edge_collapse(Complex<Real>& complex, const Submesh& submesh, Corner corner,
                      rewire::Vanishing end);

/// Tries both ends, the vertex with the smaller id first, as in algorithm 7.7 of the thesis; if
/// neither may vanish, the answer is that of the first.
template <class Real>
Verdict edge_collapse(Complex<Real>& complex, const Submesh& submesh, Edge edge);

/// The guard for a vertex inside one phase whose star has been gathered and is owned as a whole:
/// may the centre, if it is not locked, vanish into link vertex `i`? Only inversion can stop it:
/// the star is a simple polygon, and a fan of strictly positive triangles from one of its vertices
/// is a triangulation of it, whose inner edges cannot exist already. O(degree). Exact.
template <class Real>
Verdict star_collapse_guard(const Complex<Real>& complex, const Ring<Real>& ring, std::uint32_t i);

/// Tries both ends, with the whole complex as the submesh.
template <class Real>
Verdict edge_collapse(Complex<Real>& complex, Edge edge) {
    return edge_collapse(complex, whole_submesh(complex), edge);
}

// For applications: by handle, which is checked. The forms above that take corners are for the
// library's algorithms, which know that their corners are alive.

/// Whether `vanishing` may be merged into the other end of the edge; also answers not_a_simplex if
/// the edge is not alive or `vanishing` is not one of its ends. O(degree). Exact.
template <class Real>
Verdict edge_collapse_guard(const Complex<Real>& complex, const Region& region, Edge edge,
                            Vertex vanishing) {
    if (!complex.is_alive(edge)) {
        return Verdict::not_a_simplex;
    }
    const auto ends = complex.vertices_of(edge);
    if (vanishing == ends[0]) {
        return edge_collapse_guard(complex, region, edge.id, rewire::Vanishing::next);
    }
    return vanishing == ends[1]
               ? edge_collapse_guard(complex, region, edge.id, rewire::Vanishing::prev)
               : Verdict::not_a_simplex;
}

/// The guard for the whole complex.
template <class Real>
Verdict edge_collapse_guard(const Complex<Real>& complex, Edge edge, Vertex vanishing) {
    return edge_collapse_guard(complex, Region{}, edge, vanishing);
}

/// Merges `vanishing` into the other end of the edge if that is legal; the other end is not tried.
/// Thread-safe for disjoint submeshes.
template <class Real>
Verdict edge_collapse(Complex<Real>& complex, const Submesh& submesh, Edge edge, Vertex vanishing) {
    if (!complex.is_alive(edge)) {
        return Verdict::not_a_simplex;
    }
    const auto ends = complex.vertices_of(edge);
    if (vanishing == ends[0]) {
        return edge_collapse(complex, submesh, edge.id, rewire::Vanishing::next);
    }
    return vanishing == ends[1] ? edge_collapse(complex, submesh, edge.id, rewire::Vanishing::prev)
                                : Verdict::not_a_simplex;
}

/// The same, with the whole complex as the submesh.
template <class Real>
Verdict edge_collapse(Complex<Real>& complex, Edge edge, Vertex vanishing) {
    return edge_collapse(complex, whole_submesh(complex), edge, vanishing);
}

} // namespace dsc
