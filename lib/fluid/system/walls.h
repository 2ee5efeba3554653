// SPDX-License-Identifier: MIT
// The velocities that the domain boundary prescribes, node by node.
#pragma once

#include "fluid/field/snapshot_field.h"
#include "fluid/options.h"

#include <vector>

namespace dsc {

/// By 90 degrees.
[[nodiscard]] inline Point<double> turned_left(const Point<double>& v) { return {-v.y(), v.x()}; }

/// A node of the boundary where the velocity is not free. Its components are those along two
/// directions at right angles: `first`, and that turned to the left. They are the axes, unless the
/// node is on a side that slips and is not parallel to one of them.
struct WallNode {
    std::uint32_t node = 0;
    Point<double> first{1, 0};    ///< a unit vector
    std::array<bool, 2> held{};   ///< by component
    Point<double> velocity{0, 0}; ///< of a node of which both components are held
};

/// All of them, by ascending number of the node.
struct FluidWalls {
    std::vector<WallNode> nodes = {};
    bool has_open = false; ///< a part of the boundary is open
};

/// The walls of the mesh at this time. Throws InputError if the velocity of a wall is not finite.
/// O(n).
[[nodiscard]] FluidWalls walls_of(const MeshSnapshot& mesh, const FluidOptions& options,
                                  double time);

} // namespace dsc
