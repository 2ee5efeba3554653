// SPDX-License-Identifier: MIT
// Moves curves along their normals so that phases have given areas.
#pragma once

#include "geometric_flows/curvature_flow.h"
#include "geometric_flows/curve_network.h"
#include "geometric_flows/sparse_solver.h"

#include <cstdint>
#include <span>
#include <vector>

namespace dsc {

/// Finds the pressures that give phases their areas, for one network after the other: one pressure
/// for each phase moves all of its curves along their normals. Reuses its memory.
class AreaKeeper {
public:
    /// Begins with a network, which must live as long as areas in it are kept. `kept` is sorted by
    /// phase. O(vertices and edges, curves log phases).
    void begin(const CurveGraph& graph, std::span<const KeptArea> kept);

    /// The rows of the pressures for a step from these positions; empty if no area is to be kept.
    /// O(edges).
    PressureRows rows(std::span<const Vector2> positions, const InShares& in_shares);
    /// Measures the areas after displacements. Returns whether pressures have kept the areas to
    /// first order, so that the errors are of second order in the displacements; this fails if
    /// areas contradict each other. O(edges).
    bool look(std::span<const Vector2> positions, std::span<const Vector2> displacements,
              const InShares& in_shares);
    /// Corrects the displacements measured last so that each phase has its area up to rounding. The
    /// errors must be small: vertices move by the shortest way, without tension. O(edges), and a
    /// sparse factorisation for the phases.
    void shift(std::span<Vector2> displacements, const InShares& in_shares);

private:
    /// A junction, and one end of one of its curves.
    struct Arm {
        std::uint32_t junction;
        std::uint32_t curve;
        bool is_last; ///< the last anchor of the curve
        friend auto operator<=>(const Arm&, const Arm&) = default;
    };
    /// Data of a curve.
    struct Strand {
        double area = 0;         ///< area that it adds on its left and takes on its right
        double second = 0;       ///< bound of the area of second order in the displacements
        double yielding = 0;     ///< area gained for a unit of pressure, without tension
        double half_at_from = 0; ///< of the drag of its first edge
        double half_at_to = 0;   ///< of its last one
    };

    void push(std::size_t curve, std::span<const Vector2> places, bool with_drag);
    [[nodiscard]] double area_of(std::size_t curve, std::span<const Vector2> places) const;
    void find_missing();
    [[nodiscard]] bool prepare();
    template <class Visit>
    void for_each_junction(const Visit& visit) const;
    [[nodiscard]] const Vector2& push_of(const Arm& arm) const;
    [[nodiscard]] double pressure_on(std::size_t curve) const;

    const CurveGraph* graph_ = nullptr;
    Vector2 origin_{};              ///< from which areas are measured
    std::vector<KeptArea> kept_;    ///< areas that can be kept, by phase
    std::vector<Arm> arms_;         ///< sorted
    std::vector<CurvePush> pushes_; ///< by curve
    std::vector<Strand> strands_;   ///< by curve
    std::vector<Vector2> columns_;  ///< by vertex: the push, except at junctions
    std::vector<double> drag_;      ///< by vertex: half of that of its edges
    std::vector<Vector2> places_;   ///< by vertex
    std::vector<double> missing_;   ///< what each area lacks
    std::vector<double> pressures_;
    std::vector<Eigen::Triplet<double>> entries_;
    SparseSolver solver_; ///< maps areas to pressures, without tension
};

} // namespace dsc
