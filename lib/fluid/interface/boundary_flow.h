// SPDX-License-Identifier: MIT
// What the boundary of the domain does to an interface that a fluid moves: the areas that flow in
// and out, curves that end on an outlet, and ends that stay on their sides.
#pragma once

#include "fluid/interface/held_areas.h"
#include "fluid/system/conditions.h"

#include <vector>

namespace dsc {

/// The part of each phase's area that its edges on the domain boundary sweep from the origin; empty
/// in a rectangle along the axes, whose sides keep their shape exactly. O(n).
[[nodiscard]] std::vector<double> swept_by_boundary(const MeshSnapshot& mesh,
                                                    const std::vector<PhaseArea>& areas);

/// The areas that phases must have after a step, and the targets of vertices on the boundary.
class BoundaryFlow {
public:
    /// `before` at the time `start`; `inflows`, per unit of time, is empty if there is no inflow or
    /// outflow, `swept` in a rectangle. The options must outlive this.
    BoundaryFlow(const std::vector<PhaseArea>& before, double start, std::vector<double> inflows,
                 std::vector<double> swept, const Rectangle& box, const FluidOptions& options);

    /// Remeshing changes a curved side slightly, which is no flow of the fluid beside it; between
    /// the last solution and the first sub-step only remeshing changes it.
    void begin(const InterfaceView<double>& view, double time);

    /// Where a curve flows out, it ends where its last edge crosses the side, and the vertex before
    /// stays inside, to be removed once the edge is short. O(junctions).
    void cut_at_outlets(const InterfaceView<double>& view, std::span<Point<double>> targets) const;

    /// Vertices of the boundary neither follow inflow and outflow nor leave a curved side.
    /// O(interface).
    void keep_on_boundary(const InterfaceView<double>& view,
                          std::span<Point<double>> targets) const;

    /// The areas at a time of the step.
    [[nodiscard]] std::vector<PhaseArea> areas_at(double time) const;

private:
    std::vector<PhaseArea> areas_;
    double start_;
    std::vector<double> inflows_;
    std::vector<double> swept_;
    SideConditions conditions_;
    bool has_sides_; // which vertices could leave
};

} // namespace dsc
