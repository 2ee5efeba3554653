// SPDX-License-Identifier: MIT
// A corner is 4 * triangle + 0, 1 or 2. It names a vertex of a triangle, the edge opposite to it,
// and the half-edge of that edge inside the triangle, so no index ever has to be searched for.
#pragma once

#include "dsc/base/types.h"

namespace dsc {

using Corner = std::uint32_t;

/// Triangle 0 is the border: it stands in for a missing neighbour. Its phase differs from all
/// others, so "phases differ" means "constrained" for both the interface and the domain boundary.
inline constexpr std::uint32_t border_triangle = 0;
inline constexpr Corner border_corner = 0;

constexpr std::uint32_t triangle_of(Corner corner) { return corner >> 2U; }
constexpr std::uint32_t index_of(Corner corner) { return corner & 3U; }
constexpr Corner corner_of(std::uint32_t triangle, std::uint32_t index) {
    return (triangle << 2U) + index;
}
/// The next corner of the same triangle, counter-clockwise.
constexpr Corner next(Corner corner) { return index_of(corner) == 2 ? corner - 2 : corner + 1; }
/// The previous corner of the same triangle, counter-clockwise.
constexpr Corner prev(Corner corner) { return index_of(corner) == 0 ? corner + 2 : corner - 1; }
constexpr bool is_border(Corner corner) { return corner < 4; }

} // namespace dsc
