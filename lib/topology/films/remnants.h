// SPDX-License-Identifier: MIT
// Small pieces of a phase: remnants of an event, and pieces that shrink. A piece smaller than the
// smallest area vanishes into the phase with which it shares the longest outline; one of the
// exterior is shared by the fronts around it (last_piece.h).
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Removes small pieces on whose outlines the candidates lie. O(degrees): outlines of more than a
/// few edges are not followed to the end.
template <class Real>
void remove_remnants(TopologyWork<Real>& work, std::span<const Candidate> candidates);

} // namespace dsc
