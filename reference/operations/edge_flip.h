// SPDX-License-Identifier: MIT
// Edge flip: thesis algorithm 7.1 with the restrictions of section 6.5.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "reference/complex/complex.h"

namespace dsc::reference {

/// Replaces e = <v1, v2> and its two triangles by <w1, w2> and its two (figure 7.1). May return
/// not_a_simplex, on_boundary, on_submesh_boundary, on_interface or inverts.
Verdict edge_flip(const EdgeKey& e, Complex& K);

} // namespace dsc::reference
