// SPDX-License-Identifier: MIT
// The unknowns of a step: velocities at the nodes that are free to move, and pressures.
#pragma once

#include "fluid/frozen_field.h"
#include "fluid/options.h"

namespace dsc {

/// No unknown: a velocity that a wall or the interface fixes, or the one pressure that is 0.
inline constexpr int no_unknown = -1;

/// Which unknown is where. The velocity is linear along each edge between two phases: the middle
/// has no unknowns of its own. The pressure of a vertex where phases meet has one unknown for each
/// phase, so that the forces of the interface are met by jumps of the pressure exactly.
struct FluidNumbering {
    int size = 0;                                  ///< how many unknowns there are
    std::vector<std::array<int, 2>> velocity;      ///< by node: x and y
    std::vector<std::array<int, 3>> pressure;      ///< by triangle, at its vertices
    std::vector<std::uint8_t> is_middle_of_phases; ///< by node: whether it follows two vertices
};

/// Numbers the unknowns in an order in which their matrix fills in little. All unknowns of a node
/// follow each other, so that nodes are ordered (by approximate minimum degree), of which there are
/// about half as many as unknowns. O(n log n) or so.
[[nodiscard]] FluidNumbering number_unknowns(const FrozenMesh& mesh, const Walls& walls);

} // namespace dsc
