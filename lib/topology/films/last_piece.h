// SPDX-License-Identifier: MIT
// The last piece of a phase among fronts of different phases: each front takes what it would have
// reached first.
#pragma once

#include "topology/region.h"

#include <span>

namespace dsc {

/// Moves a vertex of the piece to the place that all fronts around it reach at the same time, as
/// nearly as they do, and gives each triangle about it to the phase beyond its outline. `outline`:
/// all half-edges of the piece's outline. Returns false if the piece has only one phase around it
/// or reaches the domain boundary, or its triangles are in the way: then it may have other
/// triangles. O(triangles squared).
template <class Real>
bool close_last_piece(TopologyWork<Real>& work, std::span<const Triangle> piece,
                      std::span<const Corner> outline);

} // namespace dsc
