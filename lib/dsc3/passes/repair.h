// SPDX-License-Identifier: MIT
// Mesh repair: improves bad tets that have changed.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// The effort for a tet.
enum class Effort : std::uint8_t {
    usual,
    more, ///< for blocked vertices, and for the first complex
};

/// Repairs the unfit tets, and those that become unfit, until none is left or nothing helps. Tries
/// in this order: smoothing the vertices, edge removal, face flip, edge collapse, assigning a flat
/// tet to the other phase, edge split. O(unfit tets).
void repair_mesh(PassState& state, Real quality, Effort effort);

} // namespace dsc3
