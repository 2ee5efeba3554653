// SPDX-License-Identifier: MIT
#include "fluid/numbering.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace dsc {

namespace {

std::array<bool, 2> held_by_walls(const Point<double>& p, const Rectangle& domain,
                                  const Walls& walls) {
    const bool left = p.x() == domain.low.x();
    const bool right = p.x() == domain.high.x();
    const bool bottom = p.y() == domain.low.y();
    const bool top = p.y() == domain.high.y();
    const bool sticks =
        (left && walls.left == Wall::no_slip) || (right && walls.right == Wall::no_slip) ||
        (bottom && walls.bottom == Wall::no_slip) || (top && walls.top == Wall::no_slip);
    return {sticks || left || right, sticks || bottom || top};
}

// The nodes in the order of elimination: minimum degree in the graph in which all nodes of a
// triangle are neighbours.
std::vector<std::uint32_t> elimination_order(const FrozenMesh& mesh,
                                             const std::vector<std::uint8_t>& tied) {
    const int n = static_cast<int>(mesh.nodes.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * mesh.triangles.size());
    for (const FrozenTriangle& t : mesh.triangles) {
        for (const std::uint32_t i : t.nodes) {
            for (const std::uint32_t j : t.nodes) {
                if (tied[i] == 0 && tied[j] == 0) {
                    entries.emplace_back(static_cast<int>(i), static_cast<int>(j), 1);
                }
            }
        }
    }
    Eigen::SparseMatrix<double> graph(n, n);
    graph.setFromTriplets(entries.begin(), entries.end());
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
    return {order.indices().begin(), order.indices().end()};
}

// The corners at each vertex that are of one phase have one pressure: the first of them stands for
// all, as 3 * triangle + corner.
std::vector<std::array<std::uint32_t, 3>>
leaders_of_pressures(const FrozenMesh& mesh, std::vector<std::vector<std::uint32_t>>& at_vertex) {
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

FluidNumbering number_unknowns(const FrozenMesh& mesh, const Walls& walls) {
    FluidNumbering numbers;
    numbers.is_middle_of_phases.assign(mesh.nodes.size(), 0);
    for (const FrozenEdge& edge : mesh.interface) {
        numbers.is_middle_of_phases[edge.middle] = 1;
    }
    std::vector<std::vector<std::uint32_t>> pressures(mesh.vertex_bound);
    const auto leaders = leaders_of_pressures(mesh, pressures);

    numbers.velocity.assign(mesh.nodes.size(), {no_unknown, no_unknown});
    std::vector<int> of_leader(3 * mesh.triangles.size(), no_unknown);
    const std::vector<std::uint32_t> order = elimination_order(mesh, numbers.is_middle_of_phases);
    // The pressure is determined up to a constant: the last one is 0.
    std::uint32_t last = no_id;
    for (const std::uint32_t node : order) {
        if (node < mesh.vertex_bound && !pressures[node].empty()) {
            last = pressures[node].back();
        }
    }
    for (const std::uint32_t node : order) {
        if (numbers.is_middle_of_phases[node] != 0) {
            continue;
        }
        const bool is_vertex = node < mesh.vertex_bound;
        if (is_vertex && pressures[node].empty()) {
            continue; // a free id
        }
        const auto held = held_by_walls(mesh.nodes[node], mesh.domain, walls);
        for (std::size_t k = 0; k < 2; ++k) {
            if (!held[k]) {
                numbers.velocity[node][k] = numbers.size++;
            }
        }
        if (is_vertex) {
            for (const std::uint32_t leader : pressures[node]) {
                if (leader != last) {
                    of_leader[leader] = numbers.size++;
                }
            }
        }
    }
    numbers.pressure.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            numbers.pressure[t][i] = of_leader[leaders[t][i]];
        }
    }
    return numbers;
}

} // namespace dsc
