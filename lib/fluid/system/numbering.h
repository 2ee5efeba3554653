// SPDX-License-Identifier: MIT
// The unknowns of a step: velocities at the nodes that are free to move, and pressures.
#pragma once

#include "fluid/options.h"
#include "fluid/system/dissection.h"

namespace dsc {

/// No unknown: a velocity that a wall or the interface fixes, the pressure in a void, or the one
/// pressure that is 0 where there is no void.
inline constexpr int no_unknown = -1;

/// Which unknown is where. The velocity is linear along each edge between two phases: the middle
/// has no unknowns of its own. The pressure of a vertex where phases meet has one unknown for each
/// phase, so that the forces of the interface are met by jumps of the pressure exactly.
struct FluidNumbering {
    int size = 0;                                  ///< how many unknowns there are
    std::vector<std::array<int, 2>> velocity;      ///< by node: x and y
    std::vector<std::array<int, 3>> pressure;      ///< by triangle, at its vertices
    std::vector<std::uint8_t> is_middle_of_phases; ///< by node: whether it follows two vertices
    bool has_void = false;                         ///< whether pressures are more than differences
    /// By part of the dissection: the first unknown of its inner nodes; and `size` at the end.
    std::vector<std::uint32_t> first_of_part;
};

/// Numbers the unknowns in the order of elimination, those of a node after each other. O(n phases).
[[nodiscard]] FluidNumbering number_unknowns(const MeshSnapshot& mesh, const Dissection& dissection,
                                             const FluidOptions& options);

} // namespace dsc
