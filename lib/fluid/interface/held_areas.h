// SPDX-License-Identifier: MIT
// Conserves the areas of phases by correcting the error of each motion of the interface.
#pragma once

#include "fluid/field/snapshot_field.h"

namespace dsc {

/// The area that a phase must have.
struct PhaseArea {
    Phase phase = exterior_phase; ///< which one
    double area = 0;              ///< in squared units of the domain
};

/// The areas of all phases but the exterior one, ascending by phase. O(n).
[[nodiscard]] std::vector<PhaseArea> phase_areas(const MeshSnapshot& mesh);

/// Moves targets along the normals of their curves so that the phases have these areas. Each curve
/// moves by one distance: the difference of a number for the phase on its left and one for the
/// phase on its right (0 for the exterior phase). Junctions, locked vertices and those on the
/// domain boundary stay. The error is of third order in the distances. `wanted` must be sorted by
/// phase. O(interface log phases).
void hold_areas(const InterfaceView<double>& view, const std::vector<PhaseArea>& wanted,
                std::span<Point<double>> targets);

} // namespace dsc
