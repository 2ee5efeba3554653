// SPDX-License-Identifier: MIT
// The phases on both sides of each edge: that of the innermost shape around a region, and what
// happens to gaps between shapes and to regions of two of them (compare the CoverageCleaner of
// JTS).
#pragma once

#include "dsc/initial/input/noding.h"

#include <array>
#include <span>
#include <vector>

namespace dsc::initial {

/// On the left and right of each edge, on its way from `from` to `to`. Unless the coverage is open,
/// the domain is a loop of the shape after the last. Throws InputError where shapes overlap of
/// which none lies in the other, where one has the phase of what is around it, and where gaps are
/// refused. O(n log n) for n edges.
std::vector<std::array<Phase, 2>> phases_beside(const NodedShapes& noded,
                                                std::span<const Shape> shapes,
                                                const InitialOptions& options);

} // namespace dsc::initial
