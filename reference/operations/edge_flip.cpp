// SPDX-License-Identifier: MIT
#include "reference/operations/edge_flip.h"

#include "dsc/base/verdict.h"
#include "reference/complex/algebra.h"
#include "reference/complex/geometry.h"

namespace dsc::reference {

Verdict edge_flip(const EdgeKey& e, Complex& K) {
    if (!K.is_valid_simplex(e))
        return Verdict::not_a_simplex;
    if (K.is_boundary(e))
        return Verdict::on_boundary;
    if (K.is_submesh_boundary(e))
        return Verdict::on_submesh_boundary;
    if (K.is_interface(e))
        return Verdict::on_interface;

    const SimplexSet V = boundary(e);
    const SimplexSet T = filter(2, star(K, e));
    const SimplexSet W = filter(0, closure(T)) - V;
    const Phase p = K.phase(*T.triangles.begin());
    const auto [v1, v2] = rename<2>(V.vertices);
    const auto [w1, w2] = rename<2>(W.vertices);

    // Not in the algorithm, but required by figure 4.1: the two new triangles are <v1, v2, w1> with
    // v2, and with v1, moved to w2; both must keep their orientation.
    const TriangleKey t = triangle_key(v1, v2, w1);
    if (orientation_if(K, t, v2, K.coord(w2)) <= 0 || orientation_if(K, t, v1, K.coord(w2)) <= 0) {
        return Verdict::inverts;
    }

    K.remove(e);
    K.remove(T);
    const TriangleKey t1 = K.insert(w1, w2, v1);
    const TriangleKey t2 = K.insert(w1, w2, v2);
    K.set_phase(t1, p);
    K.set_phase(t2, p);
    return Verdict::legal;
}

} // namespace dsc::reference
