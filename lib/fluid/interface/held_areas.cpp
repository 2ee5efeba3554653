// SPDX-License-Identifier: MIT
#include "fluid/interface/held_areas.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <limits>
#include <map>

namespace dsc {

namespace {

constexpr int nowhere = -1;

// The index of a phase in the list; `nowhere` for the exterior phase and the outside of the domain.
int place_of(const std::vector<PhaseArea>& areas, Phase phase) {
    const auto found = std::ranges::lower_bound(areas, phase, {}, &PhaseArea::phase);
    return found == areas.end() || found->phase != phase ? nowhere
                                                         : static_cast<int>(found - areas.begin());
}

bool can_move(const InterfaceView<double>& view, std::size_t i) {
    return (view.flags[i] & (interface_junction | interface_boundary | interface_locked)) == 0;
}

// Calls `visit(from, to, left, right)` for each edge of the interface once.
template <class Visit>
void for_each_edge(const InterfaceView<double>& view, Visit visit) {
    for (std::uint32_t i = 0; i < view.size(); ++i) {
        if (!view.is_junction(i) && !view.is_junction(view.next[i])) {
            visit(i, view.next[i], view.left[i], view.right[i]);
        }
    }
    for (std::size_t k = 0; k < view.junctions.size(); ++k) {
        const std::uint32_t i = view.junctions[k];
        for (std::uint32_t a = view.arm_begin[k]; a < view.arm_begin[k + 1]; ++a) {
            const InterfaceArm& arm = view.arms[a];
            if (!view.is_junction(arm.neighbour) || arm.neighbour > i) {
                visit(i, arm.neighbour, arm.left, arm.right);
            }
        }
    }
}

// The missing area of each phase.
Eigen::VectorXd lacks_of(const InterfaceView<double>& view, const std::vector<PhaseArea>& wanted,
                         std::span<const Point<double>> targets) {
    Eigen::VectorXd lacks(static_cast<Eigen::Index>(wanted.size()));
    for (Eigen::Index i = 0; const PhaseArea& phase : wanted) {
        lacks[i++] = phase.area;
    }
    for_each_edge(view, [&](std::uint32_t from, std::uint32_t to, Phase left, Phase right) {
        const Point<double>& a = targets[from];
        const Point<double>& b = targets[to];
        const double swept = (a.x() * b.y() - a.y() * b.x()) / 2;
        if (const int i = place_of(wanted, left); i != nowhere) {
            lacks[i] -= swept;
        }
        if (const int i = place_of(wanted, right); i != nowhere) {
            lacks[i] += swept;
        }
    });
    return lacks;
}

// The gradient of the area on the left with respect to the position of the vertex: half of the
// chord between its neighbours, rotated to the right.
Point<double> area_slope(const InterfaceView<double>& view, std::span<const Point<double>> targets,
                         std::size_t i) {
    const Point<double> chord = targets[view.next[i]] - targets[view.previous[i]];
    return Point<double>(chord.y(), -chord.x()) / 2;
}

// For each phase, the distance by which its curves move outwards.
Eigen::VectorXd distances_for(const InterfaceView<double>& view,
                              const std::vector<PhaseArea>& wanted,
                              std::span<const Point<double>> targets,
                              const Eigen::VectorXd& lacks) {
    const auto n = static_cast<int>(wanted.size());
    std::vector<Eigen::Triplet<double>> entries;
    double whole = 0;
    for (std::size_t i = 0; i < view.size(); ++i) {
        if (!can_move(view, i)) {
            continue;
        }
        const double length = area_slope(view, targets, i).norm();
        const int left = place_of(wanted, view.left[i]);
        const int right = place_of(wanted, view.right[i]);
        whole += length;
        for (const int phase : {left, right}) {
            if (phase != nowhere) {
                entries.emplace_back(phase, phase, length);
            }
        }
        if (left != nowhere && right != nowhere) {
            entries.emplace_back(std::max(left, right), std::min(left, right), -length);
        }
    }
    // A distance common to phases that meet only each other changes nothing, and some phases have
    // no vertex that can move. Adding this multiple of the length makes the distances unique.
    for (int i = 0; i < n; ++i) {
        entries.emplace_back(i, i, 1e-12 * whole + std::numeric_limits<double>::min());
    }
    Eigen::SparseMatrix<double> lengths(n, n);
    lengths.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(lengths);
    return factors.solve(lacks);
}

} // namespace

std::vector<PhaseArea> phase_areas(const MeshSnapshot& mesh) {
    std::map<Phase, double> sums;
    for (const SnapshotTriangle& t : mesh.triangles) {
        sums[t.phase] += area(mesh, t);
    }
    sums.erase(exterior_phase);
    std::vector<PhaseArea> areas;
    for (const auto& [phase, sum] : sums) {
        areas.push_back({phase, sum});
    }
    return areas;
}

void hold_areas(const InterfaceView<double>& view, const std::vector<PhaseArea>& wanted,
                std::span<Point<double>> targets) {
    std::vector<Point<double>> moves(view.size());
    for (int pass = 0; pass < 2;
         ++pass) { // Newton's method: after two passes the error is of third order
        const Eigen::VectorXd distances =
            distances_for(view, wanted, targets, lacks_of(view, wanted, targets));
        const auto distance = [&](Phase phase) {
            const int i = place_of(wanted, phase);
            return i == nowhere ? 0.0 : distances[i];
        };
        for (std::size_t i = 0; i < view.size(); ++i) {
            moves[i] = !can_move(view, i)
                           ? Point<double>(0, 0)
                           : Point<double>((distance(view.left[i]) - distance(view.right[i])) *
                                           area_slope(view, targets, i).stableNormalized());
        }
        for (std::size_t i = 0; i < view.size(); ++i) {
            targets[i] += moves[i];
        }
    }
}

} // namespace dsc
