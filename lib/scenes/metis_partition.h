// SPDX-License-Identifier: MIT
// An example of a partition that the application supplies: METIS (Karypis and Kumar, 1998) on a
// background grid. Built where METIS is installed.
#pragma once

#include "dsc/parallel/partition/places.h"

namespace dsc::scenes {

/// Two colours of `submeshes` each. The grid's squares weigh what interface is in them, and to cut
/// between two costs what interface runs there; for the second colour it also costs to cut where
/// the first did. Throws InvariantError where METIS fails. For `PlacePartitioner`; one thread.
template <class Real>
std::vector<PlaceColour> metis_colours(const PartitionInput<Real>& input, std::uint32_t submeshes);

} // namespace dsc::scenes
