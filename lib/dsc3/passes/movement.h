// SPDX-License-Identifier: MIT
// Movement: all vertices move to their targets at once; vertices that cannot are moved back. The
// result does not depend on an order, and a thin film moves as a whole.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Moves the pending interface vertices to their targets, with some layers of vertices beside them,
/// which follow less the farther away they are. If the quality of a tet falls below `move_quality`
/// and below a fraction of its old quality, the displacements of its vertices are halved, until no
/// tet does; a vertex halved four times does not move. Vertices that have arrived are no longer
/// pending; tets below `Options::quality` are listed as unfit. O(vertices that move).
void move_vertices(PassState& state, Real move_quality);

} // namespace dsc3
