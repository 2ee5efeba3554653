// SPDX-License-Identifier: MIT
// Alternates movement and mesh repair until all vertices have arrived.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Lets the pending vertices arrive at their targets, in at most `Options::max_passes` passes.
/// After the first few passes, blocking tets are repaired with more effort, and moves may leave
/// worse tets; then edges beside curves that would cross are split (passes/refinement.h), and free
/// vertices make way (passes/clearance.h); later, blocked vertices are collapsed along a short
/// interface edge under relaxed rules: arrival is more important than accuracy. Returns the number
/// of passes; vertices that have not arrived are still pending. O(vertices that move).
std::uint32_t arrive(PassState& state);

} // namespace dsc3
