// SPDX-License-Identifier: MIT
// Edge split: thesis algorithm 7.6, and the helper operation TriangleSplit, algorithm 7.2.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "reference/complex/complex.h"

#include <optional>

namespace dsc::reference {

/// Algorithm 7.2: splits `t` into two along the line from its vertex `v0` to `m`, a vertex on the
/// opposite edge. The phase is inherited.
void triangle_split(const TriangleKey& t, Vertex v0, Vertex m, Complex& K);

/// Whether splitting `t` from `v0` to a vertex at `p` would give two triangles of positive
/// orientation.
bool can_split_triangle(const TriangleKey& t, Vertex v0, const Point<double>& p, const Complex& K);

/// Algorithm 7.6: inserts a vertex on `e`, at `coord` if given (an application's interpolator, 9.2)
/// or else at the midpoint, and splits the one or two triangles (figure 7.5). May return
/// not_a_simplex, on_submesh_boundary or inverts. Interface and mesh boundary edges are legal.
Verdict edge_split(const EdgeKey& e, Complex& K,
                   const std::optional<Point<double>>& coord = std::nullopt);

} // namespace dsc::reference
