// SPDX-License-Identifier: MIT
// Junctions of the interface. Three phases at a vertex are stable; a vertex with four or more
// sectors is not, and comes apart in the way that lowers the energy of the interface the most. Two
// junctions whose common edge has shrunk away become such a vertex, and exchange their neighbours
// when it comes apart again (the T1 of foams and grains).
#pragma once

#include "dsc/topology/region.h"
#include "dsc/topology/suspicion.h"

#include <span>

namespace dsc {

/// Exchanges the neighbours of junctions among the suspects, and takes vertices with four and more
/// sectors apart. Vertices on the domain boundary stay. O(their degrees).
template <class Real>
void change_junctions(TopologyWork<Real>& work, std::span<const Suspect<Real>> suspects);

} // namespace dsc
