// SPDX-License-Identifier: MIT
// Movement and mesh repair in turn, until all vertices have arrived.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Lets the pending vertices arrive at their targets, in at most `Options::max_passes` passes.
/// After the first few, what is in the way is treated with more effort, and moves may leave worse
/// tets behind; in the end vertices that are jammed are collapsed along a short edge of the
/// interface, with laxer rules: arrival before accuracy. Returns the number of passes; vertices
/// that have not arrived are still pending. O(vertices that move).
std::uint32_t arrive(PassState& state);

} // namespace dsc3
