// SPDX-License-Identifier: MIT
// Edge flip (thesis, sections 4.2 and 7.1): the other diagonal of the two triangles at an edge.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/rewire.h"
#include "dsc/complex/submesh.h"
#include "dsc/geometry/predicates.h"

namespace dsc {

/// Whether the edge opposite to `corner` may be flipped; see Verdict for the order of the tests.
/// O(1). Exact.
template <class Real>
Verdict edge_flip_guard(const Complex<Real>& complex, const Region& region, Corner corner) {
    const Corner other = complex.twin(corner);
    const bool owned = owns_triangle(complex, region, triangle_of(corner));
    if (is_border(other)) {
        // Every simplex outside the submesh gets the same verdict.
        return owned ? Verdict::on_boundary : Verdict::on_submesh_boundary;
    }
    if (!owned || !owns_triangle(complex, region, triangle_of(other))) {
        return Verdict::on_submesh_boundary;
    }
    if (complex.phase_at(corner) != complex.phase_at(other)) {
        return Verdict::on_interface;
    }
    const auto a = complex.position(Vertex{complex.vertex(corner)});
    const auto b = complex.position(Vertex{complex.vertex(next(corner))});
    const auto w = complex.position(Vertex{complex.vertex(prev(corner))});
    const auto d = complex.position(Vertex{complex.vertex(other)});
    return orientation<Real>(a, b, d) > 0 && orientation<Real>(d, w, a) > 0 ? Verdict::legal
                                                                            : Verdict::inverts;
}

/// By handle, which is checked: also answers not_a_simplex.
template <class Real>
Verdict edge_flip_guard(const Complex<Real>& complex, Edge edge, const Region& region = {}) {
    return complex.is_alive(edge) ? edge_flip_guard(complex, region, edge.id)
                                  : Verdict::not_a_simplex;
}

/// Flips the edge opposite to `corner` if that is legal. Vertex data and all other edges' data
/// stay; the new edge gets the attributes' defaults. Thread-safe for disjoint submeshes. For
/// algorithms that know that their corners are alive.
template <class Real>
Verdict edge_flip(const Submesh<Real>& submesh, Corner corner) {
    const Verdict verdict = edge_flip_guard(submesh.complex, submesh.region, corner);
    if (verdict == Verdict::legal) {
        rewire::flip(submesh.complex, *submesh.log, corner);
    }
    return verdict;
}

/// By handle, which is checked: also answers not_a_simplex.
Verdict edge_flip(Editable auto&& where, Edge edge) {
    const Submesh submesh(where);
    const Verdict verdict =
        submesh.complex.is_alive(edge) ? edge_flip(submesh, edge.id) : Verdict::not_a_simplex;
    rethrow_failure(submesh);
    return verdict;
}

} // namespace dsc
