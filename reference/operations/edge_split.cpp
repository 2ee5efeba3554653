// SPDX-License-Identifier: MIT
#include "reference/operations/edge_split.h"

#include "dsc/base/verdict.h"
#include "reference/complex/algebra.h"
#include "reference/complex/geometry.h"

#include <algorithm>

namespace dsc::reference {

void triangle_split(const TriangleKey& t, Vertex v0, Vertex m, Complex& K) {
    const Phase p = K.phase(t);
    SimplexSet V = filter(0, full_boundary(t));
    V.erase(v0);
    K.remove(t);
    const auto [v1, v2] = rename<2>(V.vertices);
    const TriangleKey t1 = K.insert(m, v0, v1);
    const TriangleKey t2 = K.insert(m, v0, v2);
    K.set_phase(t1, p);
    K.set_phase(t2, p);
}

bool can_split_triangle(const TriangleKey& t, Vertex v0, const Point<double>& p, const Complex& K) {
    // The two parts are t with one or the other end of the split edge moved to p.
    return std::ranges::all_of(t.v,
                               [&](Vertex v) { return v == v0 || orientation_if(K, t, v, p) > 0; });
}

Verdict edge_split(const EdgeKey& e, Complex& K, const std::optional<Point<double>>& coord) {
    if (!K.is_valid_simplex(e))
        return Verdict::not_a_simplex;
    if (K.is_submesh_boundary(e))
        return Verdict::on_submesh_boundary;

    const SimplexSet V = boundary(e);
    const auto [v1, v2] = rename<2>(V.vertices);
    const SimplexSet T = filter(2, star(K, e));
    const Point<double> c = coord ? *coord : compute_midpoint(K.coord(v1), K.coord(v2));
    const auto opposite = [&](const TriangleKey& t) {
        return rename<1>((filter(0, full_boundary(t)) - V).vertices)[0];
    };
    for (const TriangleKey& t : T.triangles) {
        if (!can_split_triangle(t, opposite(t), c, K))
            return Verdict::inverts;
    }

    const Vertex m = insert_between(v1, v2, c, K);
    K.remove(e);
    for (const TriangleKey& t : T.triangles) {
        triangle_split(t, opposite(t), m, K);
    }
    return Verdict::legal;
}

} // namespace dsc::reference
