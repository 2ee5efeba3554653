// SPDX-License-Identifier: MIT
// Moves curves along their normals so that phases have given areas.
#pragma once

#include "dsc/motion/curvature_flow.h"
#include "dsc/motion/curve_network.h"

namespace dsc {

/// The area of a phase other than the exterior, from the edges around it. O(edges).
[[nodiscard]] double area_in(const CurveNetwork& network, std::span<const Point<double>> positions,
                             Phase phase);

/// Adds to the displacements from `positions` what gives each phase its area: the same speed along
/// all normals of the phase, times mobility. `kept` is sorted by phase. O(edges log phases), and a
/// sparse solve for the phases.
void keep_areas(const CurveNetwork& network, std::span<const KeptArea> kept,
                std::span<const Point<double>> positions, std::span<Point<double>> displacements);

} // namespace dsc
