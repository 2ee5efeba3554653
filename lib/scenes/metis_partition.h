// SPDX-License-Identifier: MIT
// An example of a partition that the application supplies: METIS (Karypis and Kumar, 1998) on a
// background grid. Built if METIS is installed.
#pragma once

#include "dsc/parallel/partition/partition.h"

namespace dsc::scenes {

/// Two colours of `submeshes` each. A grid square weighs as much as the interface in it, and a cut
/// between two squares costs as much as the interface that runs there; for the second colour,
/// cutting where the first did costs extra. Throws InvariantError if METIS fails. For
/// `PlacePartitioner`; one thread.
template <class Real>
std::vector<PlaceColour> metis_colours(const PartitionInput<Real>& input, std::uint32_t submeshes);

} // namespace dsc::scenes
