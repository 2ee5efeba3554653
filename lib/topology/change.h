// SPDX-License-Identifier: MIT
// Changes of topology, between two sub-steps: films open, seams go on, small pieces vanish. The
// edits are noted in the journal of the complex, from which the drivers learn of them as they do of
// an application's.
#pragma once

#include "topology/events.h"
#include "topology/options.h"
#include "topology/suspicion.h"

#include "dsc/complex/complex.h"

#include <span>
#include <vector>

namespace dsc {

/// Changes the topology around the suspects, as far as the options allow, and appends what happened
/// to `events`. Any of them may be dead, inside a phase, or named twice by now; they are reordered,
/// and the result does not depend on their order. Returns what became of the area that changed
/// hands if it is to be given back, and zeros otherwise. Serial; O(their degrees), plus the length
/// of the outline for each film that opens.
template <class Real>
AreaAccount change_topology(Complex<Real>& complex, const TopologyOptions<Real>& options,
                            Real edge_length, std::span<Suspect<Real>> suspects, double time,
                            std::vector<Event>& events);

} // namespace dsc
