// SPDX-License-Identifier: MIT
// Changes of topology, between two sub-steps: films open, seams go on, small pieces vanish. The
// edits are noted in the journal of the complex, from which the drivers learn of them as they do of
// an application's.
#pragma once

#include "topology/events.h"
#include "topology/region.h"
#include "topology/suspicion.h"

#include <span>

namespace dsc {

/// Changes the topology around the candidates, as far as the options allow, and appends what
/// happened to `work.events`. Any of them may be dead, inside a phase, or named twice by now; they
/// are reordered, and the result does not depend on their order. Returns what became of the area
/// that changed hands if it is to be given back, and zeros otherwise. O(their degrees), plus the
/// length of the outline for each film that opens. The threads of the step look for films and small
/// pieces together; all edits are serial, in the order of their places.
template <class Real>
AreaAccount change_topology(TopologyWork<Real> work, std::span<Candidate> candidates);

} // namespace dsc
