// SPDX-License-Identifier: MIT
#include "fluid/system/walls.h"

#include "dsc/geometry/side.h"

#include <map>
#include <optional>

namespace dsc {

namespace {

// An edge of the boundary, with the domain on its left.
struct WallEdge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t middle;
    Wall wall;
};

Wall wall_at(const Point<double>& from, const Point<double>& to, const Point<double>& middle,
             const Rectangle& box, const FluidOptions& options) {
    if (options.wall_at) {
        return options.wall_at(middle);
    }
    const auto is_on = [&](int axis, double place) {
        return from[axis] == place && to[axis] == place;
    };
    return is_on(0, box.low.x())    ? options.walls.left
           : is_on(0, box.high.x()) ? options.walls.right
           : is_on(1, box.low.y())  ? options.walls.bottom
           : is_on(1, box.high.y()) ? options.walls.top
                                    : options.walls.other;
}

std::vector<WallEdge> edges_of(const MeshSnapshot& mesh, const FluidOptions& options) {
    std::vector<WallEdge> edges;
    for (const SnapshotTriangle& triangle : mesh.triangles) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (triangle.across[i] == no_id) {
                const std::uint32_t from = triangle.nodes[next_index(i)];
                const std::uint32_t to = triangle.nodes[prev_index(i)];
                const std::uint32_t middle = triangle.nodes[3 + i];
                edges.push_back({from, to, middle,
                                 wall_at(mesh.nodes[from], mesh.nodes[to], mesh.nodes[middle],
                                         mesh.domain, options)});
            }
        }
    }
    return edges;
}

// The conditions of the edges at a node.
struct AtNode {
    bool sticks = false;
    std::array<std::optional<Point<double>>, 2> slips; // directions of the edges there
    std::array<std::uint32_t, 2> ends{no_id, no_id};   // the nodes before and after this one
};

void add(AtNode& at, const WallEdge& edge, const MeshSnapshot& mesh, bool is_after) {
    if (edge.wall == Wall::no_slip) {
        at.sticks = true;
    } else if (edge.wall == Wall::slip) {
        at.slips[is_after ? 1 : 0] = mesh.nodes[edge.to] - mesh.nodes[edge.from];
        at.ends[is_after ? 1 : 0] = is_after ? edge.to : edge.from;
    }
}

// The total flow through the two edges at a node is zero if the normal at the node is their mean,
// weighted by length: the normal of the line between the other ends of the edges.
WallNode slipping(std::uint32_t node, const AtNode& at, const MeshSnapshot& mesh) {
    const bool has_two = at.slips[0] && at.slips[1];
    const Point<double> way = has_two ? Point<double>(*at.slips[0] + *at.slips[1])
                                      : at.slips[0].value_or(*at.slips[at.slips[0] ? 0 : 1]);
    if (has_two && side_at<double>(mesh.nodes[at.ends[0]], mesh.nodes[node],
                                   mesh.nodes[at.ends[1]]) == Side::feature) {
        return {.node = node, .held = {true, true}};
    }
    if (way.x() == 0) {
        return {.node = node, .held = {true, false}};
    }
    if (way.y() == 0) {
        return {.node = node, .held = {false, true}};
    }
    return {.node = node, .first = way.normalized(), .held = {false, true}};
}

} // namespace

FluidWalls walls_of(const MeshSnapshot& mesh, const FluidOptions& options, double time) {
    FluidWalls walls;
    std::map<std::uint32_t, AtNode> at_nodes;
    for (const WallEdge& edge : edges_of(mesh, options)) {
        if (edge.wall == Wall::open) {
            walls.has_open = true;
            continue;
        }
        add(at_nodes[edge.from], edge, mesh, true);
        add(at_nodes[edge.to], edge, mesh, false);
        add(at_nodes[edge.middle], edge, mesh, true);
    }
    for (const auto& [node, at] : at_nodes) {
        if (!at.sticks) {
            walls.nodes.push_back(slipping(node, at, mesh));
            continue;
        }
        WallNode& held = walls.nodes.emplace_back(WallNode{.node = node, .held = {true, true}});
        if (options.wall_velocity) {
            held.velocity = options.wall_velocity(mesh.nodes[node], time);
            if (!held.velocity.allFinite()) {
                throw InputError(
                    {.what = "the velocity of a wall is not finite",
                     .where = "FluidOptions::wall_velocity at " + to_text(mesh.nodes[node]),
                     .value = to_text(held.velocity),
                     .allowed = "finite velocities"});
            }
        }
    }
    return walls;
}

} // namespace dsc
