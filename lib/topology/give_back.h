// SPDX-License-Identifier: MIT
// Gives back the area that a change of topology has taken from a phase, if the application asks for
// it: the nearest interface between the two phases moves until both have their areas of before.
#pragma once

#include "topology/region.h"

namespace dsc {

/// Repays `work.transfers`. Of each pair of phases the interface vertices nearest to the place are
/// moved along their normals, most at the place and less farther away, by no more than a tenth of
/// an edge length. The remaining error is of the size of rounding in the vertices' positions. An
/// area is not given back if the two phases have no common interface nearby, as after the last
/// piece of a phase has vanished; the result reports it.
///
/// Vertices on the domain boundary, at junctions, locked ones and features do not move. Serial; for
/// each place O(vertices within the distance that has to be searched), at most a few thousand.
template <class Real>
[[nodiscard]] AreaAccount give_back(TopologyWork<Real>& work);

} // namespace dsc
