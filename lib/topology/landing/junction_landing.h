// SPDX-License-Identifier: MIT
// The end of a seam that runs into the domain boundary. Where a front leans back from the side, its
// junction with another front arrives there before the rest of it.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Lands the junctions that are all but on a side of the domain: they become vertices of it. Before
/// films at the boundary open, because the film beyond such a junction would go to the wrong front.
/// O(candidates).
template <class Real>
void land_junctions(TopologyWork<Real>& work, std::span<const Candidate> candidates);

} // namespace dsc
