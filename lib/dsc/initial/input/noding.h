// SPDX-License-Identifier: MIT
// The borders of shapes as edges that have only ends in common: shapes are clipped at the sides of
// the domain, and points within a tolerance of another shape's border are inserted into it.
#pragma once

#include "dsc/initial/input/clipping.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dsc::initial {

/// An edge between two points, the smaller number first.
struct NodedEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    /// On whose border the edge lies; an edge that is twice in a shape's outline is not on it.
    std::vector<std::uint32_t> shapes;
    std::uint32_t loop = 0;   ///< one that it belongs to
    std::uint32_t number = 0; ///< of the edge there
};

struct NodedShapes {
    std::vector<Point<double>> points;
    std::vector<NodedEdge> edges;
    std::size_t clipped = 0;  ///< loops that were cut at the sides
    bool is_as_given = false; ///< nothing was clipped or joined, and nothing touches
};

/// Clips the loops and joins borders that are closer than `tolerance`. Throws InputError where
/// edges cross, unless they are of different shapes and `may_cross`: then the crossing becomes a
/// common point.
template <class Real>
NodedShapes node_shapes(std::vector<Loop>& loops, const Lattice& lattice, double tolerance,
                        bool may_cross = false);

} // namespace dsc::initial
