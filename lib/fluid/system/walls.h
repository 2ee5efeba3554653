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
    Point<double> velocity{0, 0}; ///< that of the held components, in x and y
    std::uint32_t side = no_id;   ///< its first one in `FluidOptions::sides`; no_id: in none
};

/// All of them, by ascending number of the node.
struct FluidWalls {
    std::vector<WallNode> nodes = {};
    bool has_open = false;   ///< a part of the boundary is open
    bool has_curved = false; ///< a part that is not open is curved
};

/// Throws InputError if a side with a condition is on no edge of the mesh, or two sides meet within
/// a straight wall where there is no vertex. To be called at the start alone: a side shorter than
/// an edge may vanish later. O(n sides + n log n), and O(n) for each such point.
void check_sides_exist(const MeshSnapshot& mesh, const FluidOptions& options);

/// The vertices at which two edges of the boundary with different conditions meet, unless an
/// interface can slide along both: they slip, or are open, alike. None with `wall_at`, whose ends
/// need not be vertices. O(n), and O(log e) for each edge of the boundary, for e edges of the
/// domain.
[[nodiscard]] std::vector<Vertex> ends_of_sides(const MeshSnapshot& mesh,
                                                const FluidOptions& options);

/// The walls of the mesh at this time. With the last solution, velocities at the middles of edges
/// are those of the fluid beside a curved wall: see `sagitta_of`. Throws InputError if the velocity
/// of a wall is not finite, or more flows in than out of a domain that is closed. O(n).
[[nodiscard]] FluidWalls walls_of(const MeshSnapshot& mesh, const FluidOptions& options,
                                  double time, const FluidField* last);

} // namespace dsc
