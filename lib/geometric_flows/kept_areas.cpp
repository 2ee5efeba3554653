// SPDX-License-Identifier: MIT
#include "geometric_flows/kept_areas.h"

#include "dsc/geometry/points.h"

#include <algorithm>
#include <numeric>

namespace dsc {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// The place of the phase in the list, which is sorted by phase, or -1.
int place_in(std::span<const KeptArea> kept, Phase phase) {
    const auto found = std::ranges::lower_bound(kept, phase, {}, &KeptArea::phase);
    return found == kept.end() || found->phase != phase ? -1
                                                        : static_cast<int>(found - kept.begin());
}

/// The areas of all kept phases.
Eigen::VectorXd areas(const CurveNetwork& network, std::span<const Point<double>> positions,
                      std::span<const KeptArea> kept) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(kept.size()));
    for (const CurveEdge& edge : network.edges) {
        // Relative to a vertex, so that an offset of all costs no digits.
        const double part =
            cross<double>(positions[edge.from] - positions[0], positions[edge.to] - positions[0]) /
            2;
        if (const int left = place_in(kept, edge.left); left >= 0) {
            sum[left] += part;
        }
        if (const int right = place_in(kept, edge.right); right >= 0) {
            sum[right] -= part;
        }
    }
    return sum;
}

/// A column for each kept phase: the derivatives of its area by the coordinates of the vertices.
Matrix area_gradients(const CurveNetwork& network, std::span<const Point<double>> positions,
                      std::span<const KeptArea> kept) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const CurveEdge& edge : network.edges) {
        const Point<double> way = positions[edge.to] - positions[edge.from];
        const auto add = [&](int column, double sign) {
            if (column < 0) {
                return;
            }
            for (const std::uint32_t i : {edge.from, edge.to}) {
                const auto row = static_cast<int>(2 * i);
                entries.emplace_back(row, column, sign * way.y() / 2);
                entries.emplace_back(row + 1, column, -sign * way.x() / 2);
            }
        };
        add(place_in(kept, edge.left), 1);
        add(place_in(kept, edge.right), -1);
    }
    Matrix gradients(static_cast<Eigen::Index>(2 * positions.size()),
                     static_cast<Eigen::Index>(kept.size()));
    gradients.setFromTriplets(entries.begin(), entries.end());
    return gradients;
}

/// How vertices move under a pressure in each phase: along the gradient of its area, as far as they
/// are free to, and the less the more drag they have.
Matrix responses(const CurveNetwork& network, std::span<const Point<double>> positions,
                 const Matrix& gradients) {
    const std::vector<double> drag = lumped_drag(network, positions);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (drag[i] > 0) {
            const Freedom& free = network.freedom[i];
            const auto row = static_cast<int>(2 * i);
            entries.emplace_back(row, row, free.xx / drag[i]);
            entries.emplace_back(row, row + 1, free.xy / drag[i]);
            entries.emplace_back(row + 1, row, free.xy / drag[i]);
            entries.emplace_back(row + 1, row + 1, free.yy / drag[i]);
        }
    }
    Matrix mobility(gradients.rows(), gradients.rows());
    mobility.setFromTriplets(entries.begin(), entries.end());
    return mobility * gradients;
}

/// Those of the phases whose areas can be kept. A phase that is absent or locked has none that
/// could change; where all phases are kept, the last one follows from the others.
std::vector<KeptArea> changeable(const CurveNetwork& network, std::span<const KeptArea> kept) {
    std::vector<std::uint8_t> is_there(kept.size(), 0);
    bool are_all_kept = true;
    const auto note = [&](Phase phase) {
        const int place = place_in(kept, phase);
        if (place >= 0) {
            is_there[static_cast<std::size_t>(place)] = 1;
        }
        are_all_kept = are_all_kept && place >= 0;
    };
    const auto can_move = [&](std::uint32_t i) {
        return network.freedom[i].xx + network.freedom[i].yy > 0;
    };
    for (const CurveEdge& edge : network.edges) {
        if (edge.forces.drag > 0 && (can_move(edge.from) || can_move(edge.to))) {
            note(edge.left);
            note(edge.right);
        }
    }
    std::vector<KeptArea> list;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        if (is_there[k] != 0) {
            list.push_back(kept[k]);
        }
    }
    if (are_all_kept && !list.empty()) {
        list.pop_back();
    }
    return list;
}

/// What changes areas: by pressures alone, without tension.
struct Pressing {
    Matrix gradients;
    Matrix responses;
    Eigen::SimplicialLDLT<Matrix> solver; ///< from areas to pressures
};

/// False if the pressures cannot be found.
bool prepare(const CurveNetwork& network, std::span<const Point<double>> positions,
             std::span<const KeptArea> kept, Pressing& pressing) {
    pressing.gradients = area_gradients(network, positions, kept);
    pressing.responses = responses(network, positions, pressing.gradients);
    const Matrix system = pressing.gradients.transpose() * pressing.responses;
    pressing.solver.compute(system);
    return pressing.solver.info() == Eigen::Success;
}

/// Written out: the compiler warns of Eigen's own.
double dot(const Eigen::VectorXd& one, const Eigen::VectorXd& other) {
    return std::inner_product(one.begin(), one.end(), other.begin(), 0.0);
}

/// The displacements by pressures during a step of the system that change the areas by `change`:
/// conjugate gradients for the pressures, preconditioned by what they do without tension.
Eigen::VectorXd press(const CurveSystem& system, const Pressing& pressing,
                      const Eigen::VectorXd& change) {
    constexpr int most_rounds = 30;
    constexpr double tolerance = 1e-8; // what remains is left to a shift
    Eigen::VectorXd displacements = Eigen::VectorXd::Zero(pressing.gradients.rows());
    Eigen::VectorXd left = change;
    Eigen::VectorXd preconditioned = pressing.solver.solve(left);
    Eigen::VectorXd direction = preconditioned;
    double size = dot(left, preconditioned);
    const double enough = tolerance * tolerance * dot(change, change);
    for (int round = 0; round < most_rounds && dot(left, left) > enough; ++round) {
        const Eigen::VectorXd response = system.response_to(pressing.gradients * direction);
        const Eigen::VectorXd by_direction = pressing.gradients.transpose() * response;
        const double slope = dot(direction, by_direction);
        if (!(slope > 0)) {
            break;
        }
        displacements += (size / slope) * response;
        left -= (size / slope) * by_direction;
        preconditioned = pressing.solver.solve(left);
        const double next = dot(left, preconditioned);
        direction = preconditioned + (next / size) * direction;
        size = next;
    }
    // Rounding errors alone would be left over by targets that contradict each other.
    if (!(dot(left, left) <= dot(change, change))) {
        displacements.setZero();
    }
    return displacements;
}

} // namespace

void keep_areas(const CurveNetwork& network, std::span<const KeptArea> kept,
                std::span<const Point<double>> positions, std::span<Point<double>> displacements,
                const CurveSystem* system) {
    // Area is quadratic in the displacement: a shift leaves about its square.
    constexpr int shifts = 3;
    const std::vector<KeptArea> list = changeable(network, kept);
    if (list.empty()) {
        return;
    }
    std::vector<Point<double>> moved(positions.begin(), positions.end());
    const auto move = [&](const Eigen::VectorXd& by) {
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const Point<double> way = by.segment<2>(static_cast<Eigen::Index>(2 * i));
            displacements[i] += way;
            moved[i] = positions[i] + displacements[i];
        }
    };
    move(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * positions.size())));
    Eigen::VectorXd wanted(static_cast<Eigen::Index>(list.size()));
    for (std::size_t k = 0; k < list.size(); ++k) {
        wanted[static_cast<Eigen::Index>(k)] = list[k].area;
    }
    Pressing pressing;
    if (!prepare(network, moved, list, pressing)) {
        return;
    }
    if (system != nullptr) {
        move(press(*system, pressing, wanted - areas(network, moved, list)));
    }
    for (int shift = 0; shift < shifts; ++shift) {
        const Eigen::VectorXd change = wanted - areas(network, moved, list);
        move(pressing.responses * pressing.solver.solve(change));
    }
}

} // namespace dsc
