// SPDX-License-Identifier: MIT
// Where the cuts of all colours run.
#pragma once

#include "dsc3/complex/ownership.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dsc3 {

/// The largest number of submeshes that is chosen by the extent.
inline constexpr std::uint32_t default_limit = 8;

/// Cuts space into up to `submeshes` cells in each colour; 0: by the extent of the places. Each cut
/// runs where it costs least: few places near it, and shares nearly equal. The first colour divides
/// all places, each later one those that are near the cuts of all colours before. Deterministic.
/// O(places + log^2 of the sample); reorders the places.
[[nodiscard]] std::array<CutTree, colour_count>
cut_colours(std::vector<Point>& places, std::uint32_t submeshes, Real edge_length);

} // namespace dsc3
