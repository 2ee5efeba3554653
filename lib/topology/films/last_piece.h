// SPDX-License-Identifier: MIT
// The last piece of a phase among fronts of different phases: each front takes what it would have
// reached first.
#pragma once

#include "topology/region.h"

#include <span>

namespace dsc {

/// What became of a piece.
enum class Closing {
    done,
    later,      ///< its fronts are too far from one place yet
    impossible, ///< it reaches the domain boundary or a phase that may not change, or its
                ///< triangles are in the way: then it may have other triangles
};

/// Moves a vertex of the piece to the place that all fronts around it reach at the same time, as
/// nearly as they do, and gives each triangle about it to the phase beyond its outline. `outline`:
/// all half-edges of the piece's outline; `fronts`: the number of phases beyond it, two or more.
/// O(triangles squared).
template <class Real>
Closing close_last_piece(TopologyWork<Real>& work, std::span<const Triangle> piece,
                         std::span<const Corner> outline, std::size_t fronts);

} // namespace dsc
