// SPDX-License-Identifier: MIT
// Interface remeshing, while all vertices are at the same time: short edges are collapsed, long
// ones split, and others flipped until the interface is Delaunay on itself.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Looks at all edges of the interface, and then, for a few rounds, at those beside what has
/// changed. A new vertex goes towards its place as far as its tets allow, and is taken to belong
/// where it ends. Tets that are below `Options::quality` afterwards are listed as unfit.
/// O(interface and what changes).
void remesh_interface(PassState& state);

} // namespace dsc3
