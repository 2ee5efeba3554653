// SPDX-License-Identifier: MIT
// The unknowns of a step: velocities at the nodes that are free to move, and pressures.
#pragma once

#include "fluid/options.h"
#include "fluid/system/dissection.h"
#include "fluid/system/walls.h"

namespace dsc {

/// Marks values that are not unknowns: a velocity fixed by a wall or the interface, the pressure in
/// a void, and without a void the one pressure that is set to 0.
inline constexpr int no_unknown = -1;

/// The numbers of the unknowns. The velocity is linear along each edge between two phases: its
/// middle has no unknowns. The pressure of a vertex where phases meet has one unknown for each
/// phase, so that jumps of the pressure balance the forces of the interface exactly.
struct FluidNumbering {
    int size = 0;                             ///< how many unknowns there are
    std::vector<std::array<int, 2>> velocity; ///< by node: x and y, or the directions in `walls`
    std::vector<std::array<int, 3>> pressure; ///< by triangle, at its vertices
    std::vector<std::uint8_t> is_middle_of_phases; ///< by node: whether it follows two vertices
    bool has_void = false;                         ///< where the pressure is 0
    FluidWalls walls;                              ///< where velocities are not free
    /// By part of the dissection: the first unknown of its inner nodes; and `size` at the end.
    std::vector<std::uint32_t> first_of_part;

    /// Whether pressures are determined absolutely rather than up to a constant.
    [[nodiscard]] bool fixes_pressure() const { return has_void || walls.has_open; }
};

/// Numbers the unknowns at this time in the order of elimination; those of a node are consecutive.
/// `last` is as for `walls_of`. O(n phases).
[[nodiscard]] FluidNumbering number_unknowns(const MeshSnapshot& mesh, const Dissection& dissection,
                                             const FluidOptions& options, double time,
                                             const FluidField* last);

} // namespace dsc
