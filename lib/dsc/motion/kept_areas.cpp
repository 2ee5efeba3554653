// SPDX-License-Identifier: MIT
#include "dsc/motion/kept_areas.h"

#include <algorithm>

namespace dsc {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

/// The place of the phase in the list, which is sorted by phase, or -1.
int place_in(std::span<const KeptArea> kept, Phase phase) {
    const auto found = std::ranges::lower_bound(kept, phase, {}, &KeptArea::phase);
    return found == kept.end() || found->phase != phase ? -1
                                                        : static_cast<int>(found - kept.begin());
}

double cross(const Point<double>& a, const Point<double>& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// The areas of all kept phases.
Eigen::VectorXd areas(const CurveNetwork& network, std::span<const Point<double>> positions,
                      std::span<const KeptArea> kept) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(kept.size()));
    for (const CurveEdge& edge : network.edges) {
        // Relative to a vertex, so that an offset of all costs no digits.
        const double part =
            cross(positions[edge.from] - positions[0], positions[edge.to] - positions[0]) / 2;
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

} // namespace

double area_in(const CurveNetwork& network, std::span<const Point<double>> positions, Phase phase) {
    const KeptArea one{.phase = phase};
    return areas(network, positions, std::span<const KeptArea>(&one, 1))[0];
}

void keep_areas(const CurveNetwork& network, std::span<const KeptArea> kept,
                std::span<const Point<double>> positions, std::span<Point<double>> displacements) {
    // Area is quadratic in the displacement: each round squares the relative error, about.
    constexpr int rounds = 4;
    const auto count = static_cast<Eigen::Index>(kept.size());
    std::vector<Point<double>> moved(positions.begin(), positions.end());
    for (std::size_t i = 0; i < moved.size(); ++i) {
        moved[i] += displacements[i];
    }
    Eigen::VectorXd wanted(count);
    for (std::size_t k = 0; k < kept.size(); ++k) {
        wanted[static_cast<Eigen::Index>(k)] = kept[k].area;
    }
    const Matrix gradients = area_gradients(network, moved, kept);
    const Matrix response = responses(network, moved, gradients);
    Matrix system = gradients.transpose() * response;
    // Where phases fill the domain without an exterior their areas have a constant sum, and a phase
    // may be absent or locked: the pressure that changes nothing is kept finite.
    double largest = 0;
    for (Eigen::Index k = 0; k < count; ++k) {
        largest = std::max(largest, system.coeff(k, k));
    }
    if (!(largest > 0)) {
        return;
    }
    Matrix identity(count, count);
    identity.setIdentity();
    system += (1e-12 * largest) * identity;
    const Eigen::SimplicialLDLT<Matrix> solver(system);
    if (solver.info() != Eigen::Success) {
        return;
    }
    for (int round = 0; round < rounds; ++round) {
        const Eigen::VectorXd pressure = solver.solve(wanted - areas(network, moved, kept));
        const Eigen::VectorXd shift = response * pressure;
        for (std::size_t i = 0; i < moved.size(); ++i) {
            const Point<double> way = shift.segment<2>(static_cast<Eigen::Index>(2 * i));
            moved[i] += way;
            displacements[i] += way;
        }
    }
}

} // namespace dsc
