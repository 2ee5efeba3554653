// SPDX-License-Identifier: MIT
// Loop subdivision: thesis algorithm 7.4, and the helper OppositeVertex, algorithm 7.3.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "reference/complex/complex.h"

#include <optional>

namespace dsc::reference {

/// Algorithm 7.3: the vertex across the edge `e` of `t`, or nil at the mesh boundary.
std::optional<Vertex> opposite_vertex(const TriangleKey& t, const EdgeKey& e, const Complex& K);

/// Algorithm 7.4: divides `t` into four triangles and splits its neighbours, if any (figure 7.2).
/// May return not_a_simplex, on_submesh_boundary, on_interface or inverts.
Verdict loop_subdivision(const TriangleKey& t, Complex& K);

} // namespace dsc::reference
