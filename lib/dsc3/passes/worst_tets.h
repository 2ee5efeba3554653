// SPDX-License-Identifier: MIT
// The last resort for the few tets at needles and caps of the interface, which no operation that
// keeps the interface as it is can improve.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Tets below this quality, about 7 degrees, are treated.
inline constexpr Real worst_tet_quality = 0.15;

/// Treats the tets that mesh repair left bad, the worst first: a short interface edge is collapsed
/// if that improves its star at all; else interface vertices are moved along the interface. Both
/// keep the interface within a fiftieth of an edge. Then the tets around are repaired. O(tets).
void improve_worst_tets(PassState& state);

} // namespace dsc3
