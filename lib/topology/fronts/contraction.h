// SPDX-License-Identifier: MIT
// Contracts a short edge across a film, so that the fronts at its ends meet in one vertex.
#pragma once

#include "topology/region.h"

#include <vector>

namespace dsc {

/// Makes one vertex of two neighbours, at a place, whatever phases are around them. Vertices inside
/// a phase make room, and edges flip, where the star would be flat. Returns the vertex that is
/// left; `no_id` if triangles are in the way. The area that curves sweep is noted. O(degrees).
template <class Real>
[[nodiscard]] std::uint32_t contract(TopologyWork<Real>& work, std::uint32_t v, std::uint32_t q,
                                     const Point<Real>& place);

/// The neighbours of a vertex, ascending.
template <class Real>
[[nodiscard]] std::vector<std::uint32_t> link_of(const Complex<Real>& complex, std::uint32_t v);

} // namespace dsc
