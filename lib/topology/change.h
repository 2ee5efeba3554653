// SPDX-License-Identifier: MIT
// Changes of topology, between two sub-steps: films open, seams continue, small pieces vanish. The
// edits are logged in the journal of the complex, from which the drivers read them like an
// application's.
#pragma once

#include "topology/candidates.h"
#include "topology/events.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Changes the topology around the candidates, as far as the options allow, and appends what
/// happened to `work.events`. Candidates may be dead, inside a phase, or listed twice by now; the
/// result does not depend on their order. Returns how much of the area that phases lost was given
/// back, if the options ask for that, and zeros otherwise. O(interface vertices * contact / edge
/// length), plus the length of the outline for each film that opens. What is slender around the
/// changes is mended, so that other vertices may move or vanish. The threads of the step share the
/// search for films and small pieces; all edits are serial, in the order of their positions.
template <class Real>
AreaAccount change_topology(TopologyWork<Real> work, std::span<const Candidate> candidates);

} // namespace dsc
