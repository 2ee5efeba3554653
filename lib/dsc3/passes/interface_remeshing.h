// SPDX-License-Identifier: MIT
// Interface remeshing, while all vertices are at the same time: short edges are collapsed, long
// ones split, and others flipped until the interface is a Delaunay triangulation of itself.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Examines all edges of the interface, and then, for a few rounds, those beside changes. A new
/// vertex moves towards its position as far as its tets allow and continues from there. Tets below
/// `Options::quality` afterwards are listed as unfit. O(interface and changed tets).
void remesh_interface(PassState& state);

} // namespace dsc3
