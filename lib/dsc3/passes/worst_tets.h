// SPDX-License-Identifier: MIT
// The last resort for the few tets at needles and caps of the interface, which no operation that
// keeps the interface as it is can improve.
#pragma once

#include "dsc3/passes/state.h"

namespace dsc3 {

/// Tets below this quality, about 7 degrees, are treated.
inline constexpr Real worst_tet_quality = 0.15;

/// Which worst tets are treated.
enum class WorstTets : std::uint8_t {
    all,
    /// In a step: between sheets that meet in a curve at a small angle most tets cannot be
    /// improved, and moves would carry markers of the flow off, again in each step.
    off_curves,
};

/// Treats the tets that mesh repair left bad, the worst first: a short interface edge is collapsed
/// if that improves its star at all; else interface vertices are moved along the interface. Both
/// keep the interface within a fiftieth of an edge. Then the tets around are repaired. O(tets).
void improve_worst_tets(PassState& state, WorstTets which);

} // namespace dsc3
