// SPDX-License-Identifier: MIT
// Triangle collapse: thesis chapter 13, figure 13.1, with the restrictions of section 6.5.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "reference/complex/complex.h"

#include <optional>

namespace dsc::reference {

/// Figure 13.1 and its caption: `t` and the triangles at its edges are removed, and in triangles
/// that share one vertex with `t` a new vertex at `place` replaces it. The default of `place` is
/// the position of the vertex of `t` that may not move, if there is one; otherwise that of the only
/// one on the interface; otherwise the centroid. With `may_change_interface` the vertices on the
/// interface may move as well. May return not_a_simplex, on_boundary, on_submesh_boundary,
/// on_interface, locked, changes_topology or inverts.
Verdict triangle_collapse(const TriangleKey& t, Complex& K,
                          const std::optional<Point<double>>& place = std::nullopt,
                          bool may_change_interface = false);

} // namespace dsc::reference
