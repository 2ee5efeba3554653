// SPDX-License-Identifier: MIT
// Laplacian smoothing: thesis, section 5.5, equation 6.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "reference/complex/complex.h"

namespace dsc::reference {

/// Moves `v` to the mean of the vertices of its link, if the smallest quality (equation 4) around
/// it increases strictly. May return not_a_simplex, on_boundary, on_submesh_boundary, on_interface,
/// locked, inverts or no_gain.
Verdict laplacian_smoothing(Vertex v, Complex& K);

} // namespace dsc::reference
