// SPDX-License-Identifier: MIT
// Small pieces of a phase: what an event leaves behind, and what shrinks away. A piece that is
// smaller than the least area vanishes into the phase with which it shares the longest outline.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Removes small pieces that the candidates lie on. O(their degrees): outlines of more than a
/// few edges are not followed to the end.
template <class Real>
void remove_remnants(TopologyWork<Real>& work, std::span<const Candidate> candidates);

} // namespace dsc
