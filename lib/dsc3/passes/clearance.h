// SPDX-License-Identifier: MIT
// Free vertices make way for vertices of the interface that have not arrived.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Of each tet at a pending vertex that would be inverted if all were at their targets, each vertex
/// that is free to move gets the target where the worst tet of its star would be best, and is
/// pending, too, for the next movement. O(degree) for each pending vertex.
void make_way(PassState& state);

} // namespace dsc3
