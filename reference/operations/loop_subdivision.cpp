// SPDX-License-Identifier: MIT
#include "reference/operations/loop_subdivision.h"

#include "dsc/base/verdict.h"
#include "reference/complex/algebra.h"
#include "reference/complex/geometry.h"
#include "reference/operations/edge_split.h"

#include <algorithm>

namespace dsc::reference {

std::optional<Vertex> opposite_vertex(const TriangleKey& t, const EdgeKey& e, const Complex& K) {
    SimplexSet T = filter(2, star(K, e));
    if (T.size() == 1) {
        return std::nullopt;
    }
    T.erase(t);
    const SimplexSet V = filter(0, closure(T)) - boundary(e);
    return rename<1>(V.vertices)[0];
}

Verdict loop_subdivision(const TriangleKey& t, Complex& K) {
    if (!K.is_valid_simplex(t))
        return Verdict::not_a_simplex;
    const SimplexSet E = boundary(t);
    const SimplexSet V = filter(0, full_boundary(t));
    const Phase p = K.phase(t);
    const auto submesh_boundary = [&](const EdgeKey& e) { return K.is_submesh_boundary(e); };
    const auto interface = [&](const EdgeKey& e) { return K.is_interface(e); };
    if (std::ranges::any_of(E.edges, submesh_boundary))
        return Verdict::on_submesh_boundary;
    if (std::ranges::any_of(E.edges, interface))
        return Verdict::on_interface;

    const auto [A, B, C] = rename<3>(V.vertices);
    const Point<double> at_a = compute_midpoint(K.coord(B), K.coord(C));
    const Point<double> at_b = compute_midpoint(K.coord(C), K.coord(A));
    const Point<double> at_c = compute_midpoint(K.coord(A), K.coord(B));
    const std::optional<Vertex> A_ = opposite_vertex(t, edge_key(B, C), K);
    const std::optional<Vertex> B_ = opposite_vertex(t, edge_key(A, C), K);
    const std::optional<Vertex> C_ = opposite_vertex(t, edge_key(A, B), K);

    // Rounded midpoints need not lie on the edges, so every new triangle is tested. The four inside
    // t are tested as t with moved vertices; sign: the order A, B, C may be clockwise.
    const int sign = dsc::orientation(K.coord(A), K.coord(B), K.coord(C));
    const auto positive = [&](const Point<double>& x, const Point<double>& y,
                              const Point<double>& z) {
        return sign * dsc::orientation(x, y, z) > 0;
    };
    if (!positive(at_a, at_b, at_c) || !positive(K.coord(A), at_c, at_b) ||
        !positive(at_c, K.coord(B), at_a) || !positive(at_b, at_a, K.coord(C)) ||
        (A_ && !can_split_triangle(triangle_key(*A_, B, C), *A_, at_a, K)) ||
        (B_ && !can_split_triangle(triangle_key(A, *B_, C), *B_, at_b, K)) ||
        (C_ && !can_split_triangle(triangle_key(A, B, *C_), *C_, at_c, K))) {
        return Verdict::inverts;
    }

    const Vertex a = insert_between(B, C, at_a, K);
    const Vertex b = insert_between(C, A, at_b, K);
    const Vertex c = insert_between(A, B, at_c, K);
    if (A_)
        triangle_split(triangle_key(*A_, B, C), *A_, a, K);
    if (B_)
        triangle_split(triangle_key(A, *B_, C), *B_, b, K);
    if (C_)
        triangle_split(triangle_key(A, B, *C_), *C_, c, K);
    K.remove(t);
    K.remove(E);
    K.set_phase(K.insert(a, b, c), p);
    K.set_phase(K.insert(A, b, c), p);
    K.set_phase(K.insert(a, B, c), p);
    K.set_phase(K.insert(a, b, C), p);
    return Verdict::legal;
}

} // namespace dsc::reference
