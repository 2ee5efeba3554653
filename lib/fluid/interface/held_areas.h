// SPDX-License-Identifier: MIT
// Holds the areas of phases: what the motion of the interface loses is brought back at once.
#pragma once

#include "fluid/field/snapshot_field.h"

namespace dsc {

/// An area that a phase has to have.
struct PhaseArea {
    Phase phase = exterior_phase; ///< which one
    double area = 0;              ///< in squared units of the domain
};

/// The areas of all phases but the exterior one, ascending by phase. O(n).
[[nodiscard]] std::vector<PhaseArea> phase_areas(const MeshSnapshot& mesh);

/// Moves targets along the normals of their curves so that the phases have these areas: each curve
/// at one distance, the difference of a number for the phase on its left and of one for that on its
/// right, of which that of the exterior is 0. Junctions, locked vertices and those on the domain
/// boundary stay. The error is of the third power in the distances. `wanted` is sorted by phase.
/// O(interface log phases).
void hold_areas(const InterfaceView<double>& view, const std::vector<PhaseArea>& wanted,
                std::span<Point<double>> targets);

} // namespace dsc
