// SPDX-License-Identifier: MIT
// Moves curves along their normals so that phases have given areas.
#pragma once

#include "geometric_flows/curvature_flow.h"
#include "geometric_flows/curve_network.h"

namespace dsc {

/// Adds to the displacements from `positions` what gives each phase its area: one pressure for each
/// phase moves all of its curves along their normals. `kept` is sorted by phase. With `system`,
/// whose last step gave these displacements, the pressures act during that step; null: what is
/// missing is small, and vertices move by the shortest way. O(edges log phases), and some solves
/// of the system: their number hardly depends on the number of phases.
void keep_areas(const CurveNetwork& network, std::span<const KeptArea> kept,
                std::span<const Point<double>> positions, std::span<Point<double>> displacements,
                const CurveSystem* system);

} // namespace dsc
