// SPDX-License-Identifier: MIT
// Gives back the area that a change of topology has taken from a phase, if the application asks for
// it: the nearest interface between the two phases moves until both have their previous areas.
#pragma once

#include "topology/region.h"

namespace dsc {

/// Repays `work.transfers`. For each pair of phases the interface vertices nearest to the event are
/// moved along their normals, most at the event and less farther away, by at most a tenth of an
/// edge length. The remaining error is of the size of rounding in the vertices' positions. An area
/// is not given back if the two phases have no common interface nearby, as after the last piece of
/// a phase has vanished; the result reports it.
///
/// Vertices on the domain boundary, at junctions, locked ones and features do not move. Serial; for
/// each place O(vertices within the distance that has to be searched), at most a few thousand.
template <class Real>
[[nodiscard]] AreaAccount give_back(TopologyWork<Real>& work);

} // namespace dsc
