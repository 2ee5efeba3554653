// SPDX-License-Identifier: MIT
#include "fluid/system/numbering.h"

#include <algorithm>

namespace dsc {

namespace {

// All corners of one phase at a vertex share one pressure. It is identified by the first of them,
// as 3 * triangle + corner.
std::vector<std::array<std::uint32_t, 3>>
leaders_of_pressures(const MeshSnapshot& mesh, std::vector<std::vector<std::uint32_t>>& at_vertex) {
    std::vector<std::array<std::uint32_t, 3>> leaders(mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            std::vector<std::uint32_t>& known = at_vertex[mesh.triangles[t].nodes[i]];
            const auto found = std::ranges::find_if(known, [&](std::uint32_t corner) {
                return mesh.triangles[corner / 3].phase == mesh.triangles[t].phase;
            });
            leaders[t][i] = found == known.end() ? known.emplace_back(3 * t + i) : *found;
        }
    }
    return leaders;
}

} // namespace

FluidNumbering number_unknowns(const MeshSnapshot& mesh, const Dissection& dissection,
                               const FluidOptions& options, double time, const FluidField* last) {
    FluidNumbering numbers;
    numbers.walls = walls_of(mesh, options, time, last);
    std::vector<std::array<bool, 2>> held(mesh.nodes.size());
    for (const WallNode& wall : numbers.walls.nodes) {
        held[wall.node] = wall.held;
    }
    numbers.is_middle_of_phases.assign(mesh.nodes.size(), 0);
    for (const SnapshotEdge& edge : mesh.interface) {
        numbers.is_middle_of_phases[edge.middle] = 1;
    }
    std::vector<std::vector<std::uint32_t>> pressures(mesh.vertex_bound);
    const auto leaders = leaders_of_pressures(mesh, pressures);
    const auto is_void = [&](std::uint32_t leader) {
        return fluid_of(options, mesh.triangles[leader / 3].phase).is_void;
    };
    numbers.has_void = std::ranges::any_of(mesh.triangles, [&](const SnapshotTriangle& t) {
        return fluid_of(options, t.phase).is_void;
    });
    // The pressure may be determined up to a constant: the last one is 0 then.
    const auto last_vertex =
        std::ranges::find_if(dissection.nodes.rbegin(), dissection.nodes.rend(),
                             [&](std::uint32_t node) { return node < mesh.vertex_bound; });
    const std::uint32_t last_leader =
        numbers.fixes_pressure() ? no_id : pressures[*last_vertex].back();

    numbers.velocity.assign(mesh.nodes.size(), {no_unknown, no_unknown});
    std::vector<int> of_leader(3 * mesh.triangles.size(), no_unknown);
    for (const MeshPart& part : dissection.parts) {
        numbers.first_of_part.push_back(static_cast<std::uint32_t>(numbers.size));
        for (std::uint32_t i = 0; i < part.node_count; ++i) {
            const std::uint32_t node = dissection.nodes[part.first_node + i];
            if (numbers.is_middle_of_phases[node] != 0) {
                continue;
            }
            for (std::size_t k = 0; k < 2; ++k) {
                if (!held[node][k]) {
                    numbers.velocity[node][k] = numbers.size++;
                }
            }
            if (node < mesh.vertex_bound) {
                for (const std::uint32_t leader : pressures[node]) {
                    if (leader != last_leader && !is_void(leader)) {
                        of_leader[leader] = numbers.size++;
                    }
                }
            }
        }
    }
    numbers.first_of_part.push_back(static_cast<std::uint32_t>(numbers.size));
    numbers.pressure.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            numbers.pressure[t][i] = of_leader[leaders[t][i]];
        }
    }
    return numbers;
}

} // namespace dsc
