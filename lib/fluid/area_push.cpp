// SPDX-License-Identifier: MIT
#include "fluid/area_push.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <limits>
#include <map>

namespace dsc {

std::vector<PhaseArea> phase_areas(const FrozenMesh& mesh) {
    std::map<Phase, double> sums;
    for (const FrozenTriangle& t : mesh.triangles) {
        sums[t.phase] += area(mesh, t);
    }
    std::vector<PhaseArea> areas;
    for (const auto& [phase, sum] : sums) {
        areas.push_back({phase, sum});
    }
    return areas;
}

std::size_t place_of(const std::vector<PhaseArea>& areas, Phase phase) {
    const auto found = std::ranges::lower_bound(areas, phase, {}, &PhaseArea::phase);
    return found == areas.end() || found->phase != phase
               ? areas.size()
               : static_cast<std::size_t>(found - areas.begin());
}

std::vector<double> area_pushes(const FrozenMesh& mesh, const std::vector<PhaseArea>& wanted,
                                double dt) {
    const auto n = static_cast<int>(wanted.size());
    Eigen::VectorXd lacks(n);
    for (Eigen::Index i = 0; const PhaseArea& phase : wanted) {
        lacks[i++] = phase.area / dt;
    }
    for (const PhaseArea& now : phase_areas(mesh)) {
        if (const std::size_t i = place_of(wanted, now.phase); i < wanted.size()) {
            lacks[static_cast<Eigen::Index>(i)] -= now.area / dt;
        }
    }
    std::vector<Eigen::Triplet<double>> entries;
    double whole = 0;
    for (const FrozenEdge& edge : mesh.interface) {
        const auto i = static_cast<int>(place_of(wanted, edge.left));
        const auto j = static_cast<int>(place_of(wanted, edge.right));
        if (i == n || j == n) {
            continue;
        }
        const double length = (mesh.nodes[edge.to] - mesh.nodes[edge.from]).norm();
        whole += length;
        entries.insert(entries.end(),
                       {{i, i, length}, {j, j, length}, {std::max(i, j), std::min(i, j), -length}});
    }
    // Equal speeds move nothing, and a phase without an interface does not move: a small share of
    // the length makes the speeds unique.
    for (int i = 0; i < n; ++i) {
        entries.emplace_back(i, i, 1e-12 * whole + std::numeric_limits<double>::min());
    }
    Eigen::SparseMatrix<double> lengths(n, n);
    lengths.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(lengths);
    const Eigen::VectorXd speeds = factors.solve(lacks);
    return {speeds.begin(), speeds.end()};
}

} // namespace dsc
