// SPDX-License-Identifier: MIT
// The Voronoi cell of each site, one by one: the domain, clipped by the bisectors to near sites
// until no remaining site can reach the cell.
#pragma once

#include "dsc/initial/initial_complex.h"

#include <span>
#include <vector>

namespace dsc::scenes {

/// What may lie beyond an edge of a cell other than a site: the sides of the domain, in
/// counter-clockwise order. Their numbers are larger than any site's.
inline constexpr std::uint32_t bottom_side = 0xfffffff0U;
inline constexpr std::uint32_t right_side = bottom_side + 1;
inline constexpr std::uint32_t top_side = bottom_side + 2;
inline constexpr std::uint32_t left_side = bottom_side + 3;

inline bool is_side(std::uint32_t beyond) { return beyond >= bottom_side; }

/// A convex polygon, counter-clockwise.
struct ClippedCell {
    std::vector<Point<double>> corners; ///< relative to the site, rounded
    std::vector<std::uint32_t> beyond;  ///< the site or side beyond the edge from corner k to k + 1
};

/// The centroid of a polygon's area. O(corners).
[[nodiscard]] Point<double> centroid(std::span<const Point<double>> corners);

/// The cell of each site, in their order. O(n) expected for n sites that are spread evenly. Throws
/// InputError for a domain that is empty or not finite, a site that is not finite or outside the
/// domain, and sites that coincide.
[[nodiscard]] std::vector<ClippedCell> clip_cells(const Rectangle& domain,
                                                  std::span<const Point<double>> sites);

} // namespace dsc::scenes
