// SPDX-License-Identifier: MIT
// Edge flip (thesis, sections 4.2 and 7.1): the other diagonal of the two triangles at an edge.
#pragma once

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
        // Every simplex outside the submesh gets the same answer.
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

/// Flips the edge opposite to `corner` if that is legal. Vertex data and all other edges' data
/// stay; the new edge gets the attributes' defaults. Thread-safe for disjoint submeshes.
template <class Real>
Verdict edge_flip(Complex<Real>& complex, const Submesh& submesh, Corner corner) {
    const Verdict verdict = edge_flip_guard(complex, submesh.region, corner);
    if (verdict == Verdict::legal) {
        rewire::flip(complex, *submesh.log, corner);
    }
    return verdict;
}

/// By handle, which is checked: answers not_a_simplex for a dead edge.
template <class Real>
Verdict edge_flip(Complex<Real>& complex, const Submesh& submesh, Edge edge) {
    return complex.is_alive(edge) ? edge_flip(complex, submesh, edge.id) : Verdict::not_a_simplex;
}

/// The same, with the whole complex as the submesh.
template <class Real>
Verdict edge_flip(Complex<Real>& complex, Edge edge) {
    return edge_flip(complex, whole_submesh(complex), edge);
}

// For applications: by handle, which is checked. The forms above that take corners are for the
// library's algorithms, which know that their corners are alive.

/// The guard by handle; also answers not_a_simplex. O(1). Exact.
template <class Real>
Verdict edge_flip_guard(const Complex<Real>& complex, const Region& region, Edge edge) {
    return complex.is_alive(edge) ? edge_flip_guard(complex, region, edge.id)
                                  : Verdict::not_a_simplex;
}

/// The guard for the whole complex.
template <class Real>
Verdict edge_flip_guard(const Complex<Real>& complex, Edge edge) {
    return edge_flip_guard(complex, Region{}, edge);
}

} // namespace dsc
