// SPDX-License-Identifier: MIT
#include "reference/operations/laplacian_smoothing.h"

#include "dsc/base/verdict.h"
#include "reference/algorithm/quality.h"
#include "reference/complex/algebra.h"
#include "reference/complex/geometry.h"

#include <algorithm>

namespace dsc::reference {

Verdict laplacian_smoothing(Vertex v, Complex& K) {
    if (!K.is_valid_simplex(v))
        return Verdict::not_a_simplex;
    if (K.is_boundary(v))
        return Verdict::on_boundary;
    if (K.is_submesh_boundary(v))
        return Verdict::on_submesh_boundary;
    if (K.is_interface(v))
        return Verdict::on_interface;
    if (K.locked.contains(v))
        return Verdict::locked;

    const SimplexSet neighbours = filter(0, link(K, v));
    Point<double> sum = Point<double>::Zero();
    for (Vertex w : neighbours.vertices)
        sum += K.coord(w);
    const Point<double> p = sum / static_cast<double>(neighbours.vertices.size());

    const std::set<TriangleKey>& T = K.triangles_at(v);
    const auto inverted = [&](const TriangleKey& t) { return orientation_if(K, t, v, p) <= 0; };
    if (std::ranges::any_of(T, inverted))
        return Verdict::inverts;

    const double before = star_quality(K, v);
    const Point<double> c = K.coord(v);
    K.set_coord(v, p);
    if (!(star_quality(K, v) > before)) {
        K.set_coord(v, c);
        return Verdict::no_gain;
    }
    return Verdict::legal;
}

} // namespace dsc::reference
