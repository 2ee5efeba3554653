// SPDX-License-Identifier: MIT
// Movement: all vertices go to their targets at once, and those that cannot go back. No order is
// involved, so that the result does not depend on who computes what, and a thin film moves as a
// whole.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Moves the pending vertices of the interface to their targets, with some layers of vertices
/// beside them, which follow less the farther they are. Where a tet falls below `move_quality` and
/// below most of what it had, the fractions of their ways that its vertices go are halved, until no
/// tet does; a vertex halved four times stays where it was. Those that have arrived are pending no
/// longer; tets below `Options::quality` are listed as unfit. O(vertices that move).
void move_vertices(PassState& state, Real move_quality);

} // namespace dsc3
