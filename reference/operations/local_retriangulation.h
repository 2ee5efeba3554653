// SPDX-License-Identifier: MIT
// Local retriangulation: thesis algorithm 7.5.
#pragma once

#include "dsc/base/types.h"
#include "dsc/base/verdict.h"
#include "reference/complex/complex.h"

namespace dsc::reference {

/// Removes the surroundings of `t` and triangulates the remaining polygon by ear clipping (figures
/// 7.3, 7.4). May return not_a_simplex, on_submesh_boundary, on_interface, locked,
/// not_a_simple_polygon or inverts.
Verdict local_retriangulation(const TriangleKey& t, Complex& K);

} // namespace dsc::reference
