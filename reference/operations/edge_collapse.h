// SPDX-License-Identifier: MIT
// Edge collapse: thesis algorithm 7.7 with the restrictions of section 6.5.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "reference/complex/complex.h"

namespace dsc::reference {

/// One iteration of the algorithm's loop: merges the end `v` of `e` into the other end. May return
/// not_a_simplex, on_boundary, on_submesh_boundary, on_interface, locked, changes_topology or
/// inverts.
Verdict collapse_end(const EdgeKey& e, Vertex v, Complex& K);

/// Algorithm 7.7: tries both ends, the smaller number first (figure 7.6); if both fail, the verdict
/// is that of the first.
Verdict edge_collapse(const EdgeKey& e, Complex& K);

} // namespace dsc::reference
