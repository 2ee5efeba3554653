// SPDX-License-Identifier: MIT
// The phases on both sides of each edge: that of the innermost shape around a region; and the
// treatment of gaps between shapes and of overlaps (compare the CoverageCleaner of JTS).
#pragma once

#include "dsc/initial/input/noding.h"

#include <array>
#include <span>
#include <vector>

namespace dsc::initial {

/// The phases on the left and right of each edge, seen from `from` to `to`. If gaps are refused or
/// given away, the sides of the domain count as the loop of one additional shape, after the last,
/// because they bound gaps too. Throws InputError where shapes overlap of which none lies in the
/// other, where one has the same phase as its surroundings, and where gaps are refused. O(n log n)
/// for n edges.
std::vector<std::array<Phase, 2>> phases_beside(const NodedShapes& noded,
                                                std::span<const Shape> shapes,
                                                const InitialOptions& options);

} // namespace dsc::initial
