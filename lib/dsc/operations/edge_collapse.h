// SPDX-License-Identifier: MIT
// Edge collapse (thesis, sections 4.2 and 7.5): an edge shrinks to one of its ends.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/rewire.h"
#include "dsc/complex/submesh.h"

#include <optional>
#include <utility>

namespace dsc {

/// Whether a junction may be merged into another one along the interface edge between them, or the
/// end of a curve into another vertex along the domain boundary.
enum class JunctionRule : std::uint8_t { kept, may_merge };

/// How the domain boundary is taken: exactly (thesis, section 6.5), so that a vertex may only leave
/// where it is straight; or up to rounding and `side_deviation`, so that a vertex may leave where
/// it keeps its shape, and three vertices of a side make no triangle, along whichever direction.
enum class BoundaryRule : std::uint8_t { exact, smooth };

/// Whether the vanishing end v of the edge opposite to `corner` may be merged into the other end.
/// An interface vertex may be merged along its interface, a boundary vertex along the boundary.
/// O(degree). The tests are exact, except those of `BoundaryRule::smooth`.
template <class Real>
Verdict edge_collapse_guard(const Complex<Real>& complex, const Region& region, Corner corner,
                            rewire::Vanishing end, JunctionRule junctions = JunctionRule::kept,
                            BoundaryRule boundary = BoundaryRule::exact);

/// The end of an edge that a vertex is, seen from the corner that names the edge; empty if the edge
/// is not alive or the vertex is not one of its ends. O(1).
template <class Real>
[[nodiscard]] std::optional<rewire::Vanishing> end_of(const Complex<Real>& complex, Edge edge,
                                                      Vertex vertex) {
    if (!complex.is_alive(edge)) {
        return {};
    }
    const auto [first, second] = complex.vertices_of(edge);
    return vertex == first    ? std::optional(rewire::Vanishing::next)
           : vertex == second ? std::optional(rewire::Vanishing::prev)
                              : std::nullopt;
}

/// Whether `vanishing` may be merged into the other end of the edge; also answers not_a_simplex if
/// the edge is not alive or `vanishing` is not one of its ends.
template <class Real>
Verdict edge_collapse_guard(const Complex<Real>& complex, Edge edge, Vertex vanishing,
                            const Region& region = {}) {
    const auto end = end_of(complex, edge, vanishing);
    return end ? edge_collapse_guard(complex, region, edge.id, *end) : Verdict::not_a_simplex;
}

/// Whether the centre of a gathered star, inside one phase and owned as a whole, may vanish into
/// link vertex `i`; also answers locked. Otherwise only inversion can stop it: the star is a simple
/// polygon, and strictly positive triangles from one of its vertices to the others triangulate it,
/// with inner edges that cannot exist already. O(degree). Exact.
template <class Real>
Verdict star_collapse_guard(const Complex<Real>& complex, const Star<Real>& star, std::uint32_t i);

/// Collapses in that direction if it is legal. Thread-safe for disjoint submeshes. For algorithms
/// that know that their corners are alive.
template <class Real>
Verdict edge_collapse(const Submesh<Real>& submesh, Corner corner, rewire::Vanishing end,
                      BoundaryRule boundary = BoundaryRule::exact) {
    const Verdict verdict = edge_collapse_guard(submesh.complex, submesh.region, corner, end,
                                                JunctionRule::kept, boundary);
    if (verdict == Verdict::legal) {
        rewire::collapse(submesh.complex, *submesh.log, corner, end, *submesh.pool);
    }
    return verdict;
}

/// Merges `vanishing` into the other end of the edge if that is legal; the other end is not tried.
/// By handle, which is checked: also answers not_a_simplex.
Verdict edge_collapse(Editable auto&& where, Edge edge, Vertex vanishing) {
    const Submesh submesh(where);
    const auto end = end_of(submesh.complex, edge, vanishing);
    const Verdict verdict = end ? edge_collapse(submesh, edge.id, *end) : Verdict::not_a_simplex;
    rethrow_failure(submesh);
    return verdict;
}

/// Tries both ends, the vertex with the smaller id first, as in algorithm 7.7 of the thesis; if
/// neither may vanish, the answer is that of the first.
Verdict edge_collapse(Editable auto&& where, Edge edge) {
    const Submesh submesh(where);
    if (!submesh.complex.is_alive(edge)) {
        return Verdict::not_a_simplex;
    }
    auto [first, second] = submesh.complex.vertices_of(edge);
    if (second.id < first.id) {
        std::swap(first, second);
    }
    const Verdict verdict = edge_collapse(submesh, edge, first);
    return verdict == Verdict::legal || edge_collapse(submesh, edge, second) == Verdict::legal
               ? Verdict::legal
               : verdict;
}

} // namespace dsc
