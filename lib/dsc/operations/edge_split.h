// SPDX-License-Identifier: MIT
// Edge split (thesis, sections 4.2 and 7.4): a new vertex on an edge, and its one or two triangles
// cut in two.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/rewire.h"
#include "dsc/complex/submesh.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"

namespace dsc {

/// Whether the edge opposite to `corner` may be split at `point`. O(1). Exact. Only the triangles
/// at the edge are tested: a point off an edge of the domain boundary changes the domain, and the
/// caller must ensure that it touches nothing outside.
template <class Real>
Verdict edge_split_guard(const Complex<Real>& complex, const Region& region, Corner corner,
                         const Point<Real>& point) {
    const Corner other = complex.twin(corner);
    if (!owns_triangle(complex, region, triangle_of(corner)) ||
        (!is_border(other) && !owns_triangle(complex, region, triangle_of(other)))) {
        return Verdict::on_submesh_boundary;
    }
    const auto a = complex.position(Vertex{complex.vertex(corner)});
    const auto b = complex.position(Vertex{complex.vertex(next(corner))});
    const auto w = complex.position(Vertex{complex.vertex(prev(corner))});
    if (orientation<Real>(a, b, point) <= 0 || orientation<Real>(a, point, w) <= 0) {
        return Verdict::inverts;
    }
    if (!is_border(other)) {
        const auto d = complex.position(Vertex{complex.vertex(other)});
        if (orientation<Real>(d, w, point) <= 0 || orientation<Real>(d, point, b) <= 0) {
            return Verdict::inverts;
        }
    }
    return Verdict::legal;
}

/// By handle, which is checked: also answers not_a_simplex.
template <class Real>
Verdict edge_split_guard(const Complex<Real>& complex, Edge edge,
                         const std::type_identity_t<Point<Real>>& point,
                         const Region& region = {}) {
    return complex.is_alive(edge) ? edge_split_guard<Real>(complex, region, edge.id, point)
                                  : Verdict::not_a_simplex;
}

/// What a split did.
struct SplitResult {
    Verdict verdict = Verdict::legal; ///< `legal`, or what stopped it
    Vertex vertex;                    ///< the new vertex, if legal
};

/// Splits the edge opposite to `corner` at `point` if that is legal. The caller chooses the
/// interpolator that yields `point`. Vertex attributes are blended at the parameter of `point`
/// along the edge. Thread-safe for disjoint submeshes. For algorithms that know that their corners
/// are alive.
template <class Real>
SplitResult edge_split(const Submesh<Real>& submesh, Corner corner, const Point<Real>& point) {
    Complex<Real>& complex = submesh.complex;
    const Verdict verdict = edge_split_guard(complex, submesh.region, corner, point);
    if (verdict != Verdict::legal) {
        return {verdict, {}};
    }
    IdPool& pool = *submesh.pool;
    const std::size_t needed = is_border(complex.twin(corner)) ? 1 : 2;
    if (!complex.have_ids(pool, 1, needed)) {
        return {Verdict::out_of_ids, {}};
    }
    const std::uint32_t m = complex.take_vertex(pool);
    const std::uint32_t t2 = complex.take_triangle(pool);
    const std::uint32_t u2 = is_border(complex.twin(corner)) ? no_id : complex.take_triangle(pool);
    rewire::split(complex, *submesh.log, corner, m, point, t2, u2);
    return {Verdict::legal, Vertex{m}};
}

/// By handle, which is checked: also answers not_a_simplex.
template <Editable Where>
SplitResult edge_split(Where&& where, Edge edge, const Point<ScalarOf<Where>>& point) {
    const Submesh submesh(where);
    const SplitResult result = submesh.complex.is_alive(edge)
                                   ? edge_split(submesh, edge.id, point)
                                   : SplitResult{Verdict::not_a_simplex, {}};
    rethrow_failure(submesh);
    return result;
}

/// The same at the midpoint.
template <Editable Where>
SplitResult edge_split(Where&& where, Edge edge) {
    const Submesh submesh(where);
    if (!submesh.complex.is_alive(edge)) {
        return {Verdict::not_a_simplex, {}};
    }
    const auto [a, b] = submesh.complex.vertices_of(edge);
    return edge_split(
        submesh, edge,
        midpoint<ScalarOf<Where>>(submesh.complex.position(a), submesh.complex.position(b)));
}

} // namespace dsc
