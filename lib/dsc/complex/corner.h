// SPDX-License-Identifier: MIT
// A corner is 4 * triangle + 0, 1 or 2. It names a vertex of a triangle, the edge opposite to it,
// and the half-edge of that edge inside the triangle, so no index ever has to be searched for.
#pragma once

#include "dsc/base/types.h"

namespace dsc {

/// A corner by number; also names the edge and the half-edge opposite to it.
using Corner = std::uint32_t;

/// Triangle 0 is the border: it stands in for a missing neighbour. Its phase differs from all
/// others, so "phases differ" means "constrained" for both the interface and the domain boundary.
inline constexpr std::uint32_t border_triangle = 0;
/// A corner of the border: what is on the other side of the domain's edges.
inline constexpr Corner border_corner = 0;

/// Ids of triangles are below this: there are four corners for each.
inline constexpr std::uint32_t triangle_limit = no_id / 4;

/// The triangle of a corner.
constexpr std::uint32_t triangle_of(Corner corner) { return corner >> 2U; }
/// The index of a corner in its triangle: 0, 1 or 2.
constexpr std::uint32_t index_of(Corner corner) { return corner & 3U; }
/// Corner `index` (0, 1 or 2) of a triangle.
constexpr Corner corner_of(std::uint32_t triangle, std::uint32_t index) {
    return (triangle << 2U) + index;
}
/// The index after another one, counter-clockwise.
constexpr std::uint32_t next_index(std::uint32_t index) { return index == 2 ? 0 : index + 1; }
/// The index before another one, counter-clockwise.
constexpr std::uint32_t prev_index(std::uint32_t index) { return index == 0 ? 2 : index - 1; }
/// The next corner of the same triangle, counter-clockwise.
constexpr Corner next(Corner corner) { return index_of(corner) == 2 ? corner - 2 : corner + 1; }
/// The previous corner of the same triangle, counter-clockwise.
constexpr Corner prev(Corner corner) { return index_of(corner) == 0 ? corner + 2 : corner - 1; }
/// Whether a corner belongs to the border: there is no neighbour.
constexpr bool is_border(Corner corner) { return corner < 4; }

} // namespace dsc
