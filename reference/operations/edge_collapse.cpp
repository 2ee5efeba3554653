// SPDX-License-Identifier: MIT
#include "reference/operations/edge_collapse.h"

#include "dsc/base/verdict.h"
#include "reference/complex/algebra.h"
#include "reference/complex/geometry.h"

#include <algorithm>

namespace dsc::reference {

namespace {

/// Section 6.5: the domain keeps its shape if `e` is a boundary edge and the boundary is straight
/// at `v`.
bool may_leave_boundary(const EdgeKey& e, Vertex v, const Complex& K) {
    return K.is_boundary(e) && K.straight_boundary(v);
}

/// Section 6.5: the interface is coarsened, not broken, if `e` is part of it and `v` is neither a
/// junction nor an end.
bool may_leave_interface(const EdgeKey& e, Vertex v, const Complex& K) {
    return K.is_interface(e) && std::ranges::count_if(K.edges_at(v), [&](const EdgeKey& f) {
                                    return K.is_interface(f);
                                }) == 2;
}

/// Two checks that the algorithm of the thesis lacks. A triangle of star(e) vanishes and its other
/// two edges become one: if both are constrained, a phase or a strip of the domain would vanish. If
/// the links meet in more than link(e), triangles would coincide: the link condition of T. K. Dey
/// et al., "Topology preserving edge contraction" (1999).
bool changes_topology(const EdgeKey& e, Vertex v, Vertex v_, const SimplexSet& T,
                      const Complex& K) {
    for (const TriangleKey& t : T.triangles) {
        const auto constrained = [&](const EdgeKey& f) { return f != e && K.is_constrained(f); };
        if (std::ranges::count_if(edges_of(t), constrained) == 2)
            return true;
    }
    return (link(K, v) & link(K, v_)) != link(K, e);
}

} // namespace

Verdict collapse_end(const EdgeKey& e, Vertex v, Complex& K) {
    if (!K.is_valid_simplex(e) || !has_vertex(e, v))
        return Verdict::not_a_simplex;
    if (K.is_boundary(v) && (K.boundary_features.contains(v) || !may_leave_boundary(e, v, K)))
        return Verdict::on_boundary;
    if (K.is_submesh_boundary(e))
        return Verdict::on_submesh_boundary;
    if (K.is_submesh_boundary(v))
        return Verdict::on_submesh_boundary;
    if (K.is_interface(v) && !may_leave_interface(e, v, K))
        return Verdict::on_interface;
    if (K.locked.contains(v))
        return Verdict::locked;

    const SimplexSet T = filter(2, star(K, e));
    const Vertex v_ = rename<1>((boundary(e) - closure(v)).vertices)[0];
    const SimplexSet T_ = filter(2, star(K, v)) - T;
    if (changes_topology(e, v, v_, T, K))
        return Verdict::changes_topology;

    const Point<double> c = K.coord(v);
    K.set_coord(v, K.coord(v_));
    const auto inverted = [&](const TriangleKey& t) { return K.orientation(t) <= 0; };
    const bool any_inverted = std::ranges::any_of(T_.triangles, inverted);
    K.set_coord(v, c);
    if (any_inverted)
        return Verdict::inverts;

    for (const TriangleKey& t : T_.triangles) {
        const Phase p = K.phase(t);
        const auto [a, b] = rename<2>((full_boundary(t) - closure(v)).vertices);
        K.remove(t);
        K.set_phase(K.insert(v_, a, b), p);
    }
    // The thesis has Remove(v). Simplices that have v as a face must be removed too.
    K.remove(star(K, v));
    return Verdict::legal;
}

Verdict edge_collapse(const EdgeKey& e, Complex& K) {
    const Verdict first = collapse_end(e, e.v[0], K);
    if (first == Verdict::legal || collapse_end(e, e.v[1], K) == Verdict::legal) {
        return Verdict::legal;
    }
    return first;
}

} // namespace dsc::reference
