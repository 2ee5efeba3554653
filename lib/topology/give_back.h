// SPDX-License-Identifier: MIT
// Area that a change of topology has taken from a phase is given back to it, where the application
// asks for that: the nearest interface between the two phases moves until both have what they had
// before.
#pragma once

#include "topology/region.h"

namespace dsc {

/// Settles `work.transfers`. Of each pair of phases the interface vertices nearest to the place are
/// moved along their normals, most at the place and less farther away, by no more than a tenth of
/// an edge length. What remains after that is as small as the rounding of the vertices' positions.
/// An area is not given back if the two phases have no common interface nearby, as after the last
/// piece of a phase has vanished; it is told in the result.
///
/// Vertices on the domain boundary, at junctions, locked ones and corners do not move. Serial; for
/// each place O(vertices within the distance that has to be searched), at most a few thousand.
template <class Real>
[[nodiscard]] AreaAccount give_back(TopologyWork<Real>& work);

} // namespace dsc
