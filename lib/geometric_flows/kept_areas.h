// SPDX-License-Identifier: MIT
// Moves curves along their normals so that phases have given areas.
#pragma once

#include "geometric_flows/curvature_flow.h"
#include "geometric_flows/curve_network.h"
#include "geometric_flows/sparse_solver.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace dsc {

/// The pressures in the phases of one network after the other that give them their areas. Reuses
/// its memory.
class AreaKeeper {
public:
    /// Takes up a network, which must live as long as areas in it are kept. `kept` is sorted by
    /// phase. O(edges log phases).
    void begin(const CurveNetwork& network, std::span<const KeptArea> kept);

    /// Adds to the displacements from `positions` what gives each phase its area: one pressure for
    /// each phase moves all of its curves along their normals. With `system`, whose last step gave
    /// these displacements, the pressures act during that step; null: what is missing is small, and
    /// vertices move by the shortest way. O(edges), and some solves of the system: their number
    /// hardly depends on the number of phases, and is smaller where the pressures of the step
    /// before, in the same network, are nearly right.
    void keep(std::span<const Point<double>> positions, std::span<Point<double>> displacements,
              CurveSystem* system);

private:
    using Vector = Eigen::VectorXd;
    /// Places of two phases in the list of those that are kept, or -1.
    struct Sides {
        int left = -1;
        int right = -1;
        friend auto operator<=>(const Sides&, const Sides&) = default;
    };

    void find_sides();
    void find_missing(std::span<const Point<double>> positions,
                      std::span<const Point<double>> displacements);
    bool prepare(std::span<const Point<double>> positions,
                 std::span<const Point<double>> displacements);
    void add_junctions();
    void push(const Vector& pressures, std::span<Point<double>> forces) const;
    [[nodiscard]] Vector gained_by(std::span<const Point<double>> displacements) const;
    void press(CurveSystem& system, std::span<Point<double>> displacements);
    void shift(std::span<Point<double>> displacements);

    const CurveNetwork* network_ = nullptr;
    std::vector<KeptArea> kept_;          ///< those that can be, by phase
    std::vector<Sides> sides_;            ///< by edge
    std::vector<Sides> pairs_;            ///< of all edges, each once, the smaller place first
    std::vector<std::uint32_t> pair_of_;  ///< by edge: its place in `pairs_`
    std::vector<std::uint32_t> curve_of_; ///< by vertex of a curve: one of its edges
    std::vector<std::pair<std::uint32_t, std::uint32_t>> arms_; ///< junctions with their edges

    std::vector<Point<double>>
        normals_; ///< by edge: half of its length along the normal to its right
    std::vector<Point<double>> across_; ///< by vertex of a curve: the sum of those of its edges
    std::vector<double> drag_;          ///< by vertex
    std::vector<double> sums_;          ///< by pair
    std::vector<Eigen::Triplet<double>> entries_;
    std::vector<Point<double>> moves_; ///< by vertex
    std::vector<Point<double>> total_; ///< by vertex
    SparseSolver solver_;              ///< from areas to pressures, without tension
    Vector pressures_;                 ///< of the last step
    Vector missing_;                   ///< what each area lacks
};

} // namespace dsc
