// SPDX-License-Identifier: MIT
// Voronoi regions as submeshes (thesis, section 6): colours for a `PlacePartitioner`.
#pragma once

#include "thesis/divisions/places.h"

#include <vector>

namespace dsc {

/// Voronoi regions of points (thesis, section 6): the submesh of a place is the number of the
/// nearest point, the lower number in a tie. O(1) expected per look-up.
PlaceColour voronoi_colour(std::vector<Point<double>> sites);

/// The same for sites that follow the interface: k-means of its vertices (Lloyd's algorithm,
/// `rounds` times, from vertices evenly spread along the list). These are the "springs" of the
/// thesis, section 6, which even out the submeshes. The second colour's sites lie in the middle
/// between neighbouring sites of the first.
template <class Real>
std::vector<PlaceColour> voronoi_colours(const PartitionInput<Real>& input, std::uint32_t submeshes,
                                         int rounds = 8);

} // namespace dsc
