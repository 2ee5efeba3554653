// SPDX-License-Identifier: MIT
// Do the edges of a network of curves touch anywhere but at common ends? With a uniform grid over
// short pieces of them, and exact signs.
#pragma once

#include "dsc/base/types.h"

#include <optional>
#include <span>
#include <vector>

namespace dsc::initial {

/// A straight line by the numbers of its ends. Lines that share a number may meet there.
struct NetworkEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
};

/// An edge cut into pieces whose points are rounded, so that they may lie beside the edge.
struct NetworkPiece {
    NetworkEdge line;
    std::uint32_t edge = 0; ///< of which it is a part
};

/// Two edges that have a point in common and should not, the smaller number first.
struct EdgeContact {
    std::uint32_t edge = 0;
    std::uint32_t other_edge = 0;

    friend auto operator<=>(const EdgeContact&, const EdgeContact&) = default;
};

/// The first contact, of the edges as well as of their pieces, if there is any. Pieces lie within
/// `reach` of their edges. O(pieces) expected, if they are spread evenly.
std::optional<EdgeContact> find_contact(std::span<const Point<double>> points,
                                        std::span<const NetworkEdge> edges,
                                        std::span<const NetworkPiece> pieces, double reach);

} // namespace dsc::initial
