// SPDX-License-Identifier: MIT
// Refinement where the chords of junction curves would cross at the targets of the flow.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Where two curves leave a point at a small angle, a chord of one cuts off vertices of the other,
/// though the curves do not cross: no movement lets all of them arrive. Of each tet beside a
/// pending vertex near a curve that would be inverted if all vertices were at their targets, the
/// longest edge on the interface is split at its middle; the new vertices are pending, too, with
/// targets on the curved edges. Returns false, and does nothing, if no pending vertex has one of a
/// junction curve, or itself, in its star. O(degree^2) for each pending vertex.
bool refine_crossings(PassState& state);

} // namespace dsc3
