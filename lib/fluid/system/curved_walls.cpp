// SPDX-License-Identifier: MIT
#include "fluid/system/curved_walls.h"

#include "dsc/geometry/side.h"

#include <algorithm>
#include <utility>

namespace dsc {

Point<double> sagitta_of(const MeshSnapshot& mesh, std::uint32_t before, std::uint32_t from,
                         std::uint32_t to, std::uint32_t after) {
    const Point<double>& a = mesh.nodes[from];
    const Point<double>& b = mesh.nodes[to];
    const auto is_marked = [&](std::uint32_t vertex) {
        return std::ranges::binary_search(mesh.features, vertex);
    };
    const Side at_a = side_at<double>(mesh.nodes[before], a, b, is_marked(from));
    const Side at_b = side_at<double>(a, b, mesh.nodes[after], is_marked(to));
    if (at_a == Side::straight || at_b == Side::straight) {
        return {0, 0};
    }
    const double half = (b - a).norm() / 2;
    Point<double> sum(0, 0);
    int circles = 0;
    for (const auto& [side, neighbour] : {std::pair(at_a, before), std::pair(at_b, after)}) {
        if (side != Side::feature) {
            sum += point_of_side<double>(a, mesh.nodes[neighbour], b, half);
            ++circles;
        }
    }
    return circles == 0 ? Point<double>(0, 0) : Point<double>(sum / circles - (a + b) / 2);
}

Point<double> change_to_wall(const FluidField& last, const MeshSnapshot& mesh,
                             const SnapshotTriangle& triangle, std::uint32_t middle,
                             const Point<double>& sagitta) {
    const Spot spot =
        find_spot(last.mesh, mesh.nodes[middle], start_at(last.mesh, triangle.nodes[0]));
    double longest = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        longest = std::max(
            longest,
            (mesh.nodes[triangle.nodes[next_index(i)]] - mesh.nodes[triangle.nodes[i]]).norm());
    }
    const double height = 2 * area(mesh, triangle) / longest;
    const double share = std::min(1.0, height / (4 * sagitta.norm()));
    return share * velocity_along(last, spot, sagitta);
}

} // namespace dsc
