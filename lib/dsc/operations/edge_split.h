// SPDX-License-Identifier: MIT
// Edge split (thesis, sections 4.2 and 7.4): a new vertex on an edge, and its one or two triangles
// cut in two.
#pragma once

#include "dsc/base/verdict.h"
#include "dsc/complex/rewire.h"
#include "dsc/complex/submesh.h"
#include "dsc/geometry/distance.h"
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

/// What a split did.
struct SplitResult {
    Verdict verdict = Verdict::legal; ///< `legal`, or what stopped it
    Vertex vertex;                    ///< the new vertex, if legal
};

/// Splits the edge opposite to `corner` at `point` if that is legal. Only the position needs to be
/// known, so the choice of interpolator is the caller's. Vertex attributes are blended
/// where it lies along the edge. Thread-safe for disjoint submeshes.
template <class Real>
SplitResult edge_split(Complex<Real>& complex, const Submesh& submesh, Corner corner,
                       const Point<Real>& point) {
    Verdict verdict = edge_split_guard(complex, submesh.region, corner, point);
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

/// By handle, which is checked: answers not_a_simplex for a dead edge.
template <class Real>
SplitResult edge_split(Complex<Real>& complex, const Submesh& submesh, Edge edge,
                       const Point<Real>& point) {
    return complex.is_alive(edge) ? edge_split(complex, submesh, edge.id, point)
                                  : SplitResult{Verdict::not_a_simplex, {}};
}

/// Splits an edge at its midpoint.
template <class Real>
SplitResult edge_split(Complex<Real>& complex, const Submesh& submesh, Edge edge) {
    if (!complex.is_alive(edge)) {
        return {Verdict::not_a_simplex, {}};
    }
    const auto [a, b] = complex.vertices_of(edge);
    return edge_split(complex, submesh, edge.id,
                      midpoint<Real>(complex.position(a), complex.position(b)));
}

/// Splits an edge at its midpoint, with the whole complex as the submesh.
template <class Real>
SplitResult edge_split(Complex<Real>& complex, Edge edge) {
    return edge_split(complex, whole_submesh(complex), edge);
}

// For applications: by handle, which is checked. The forms above that take corners are for the
// library's algorithms, which know that their corners are alive.

/// The guard by handle; also answers not_a_simplex. O(1). Exact.
template <class Real>
Verdict edge_split_guard(const Complex<Real>& complex, const Region& region, Edge edge,
                         const Point<Real>& point) {
    return complex.is_alive(edge) ? edge_split_guard(complex, region, edge.id, point)
                                  : Verdict::not_a_simplex;
}

/// The guard for the whole complex.
template <class Real>
Verdict edge_split_guard(const Complex<Real>& complex, Edge edge, const Point<Real>& point) {
    return edge_split_guard(complex, Region{}, edge, point);
}

/// Splits an edge at `point`, with the whole complex as the submesh.
template <class Real>
SplitResult edge_split(Complex<Real>& complex, Edge edge, const Point<Real>& point) {
    return edge_split(complex, whole_submesh(complex), edge, point);
}

} // namespace dsc
