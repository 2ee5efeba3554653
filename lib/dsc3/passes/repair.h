// SPDX-License-Identifier: MIT
// Mesh repair: bad tets, where something has changed, are made better.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// How much is tried for a tet.
enum class Effort : std::uint8_t {
    usual,
    more, ///< where a vertex does not arrive, and for the first complex
};

/// Treats the unfit tets, and those that this makes unfit, until none is left or nothing helps: its
/// vertices are smoothed; else an edge is removed, a face flipped, an edge collapsed, a flat tet
/// given to the other phase, or an edge split. O(unfit tets).
void repair_mesh(PassState& state, Real quality, Effort effort);

} // namespace dsc3
