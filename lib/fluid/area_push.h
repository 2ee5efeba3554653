// SPDX-License-Identifier: MIT
// Holds the areas of phases: no fluid is lost to the error of the motion.
#pragma once

#include "fluid/frozen_field.h"

namespace dsc {

/// An area that a phase has to have.
struct PhaseArea {
    Phase phase = exterior_phase;
    double area = 0;

    friend bool operator==(const PhaseArea&, const PhaseArea&) = default;
};

/// The areas of all phases, ascending by phase. O(n).
[[nodiscard]] std::vector<PhaseArea> phase_areas(const FrozenMesh& mesh);

/// A speed for each phase of `wanted`: if each point of the interface moved along its normal at the
/// speed of the phase behind it less that of the phase before it, phases would have the wanted
/// areas after `dt`, to first order. `wanted` is sorted by phase,
/// and names the phases of the mesh and others. O(n log phases).
[[nodiscard]] std::vector<double> area_pushes(const FrozenMesh& mesh,
                                              const std::vector<PhaseArea>& wanted, double dt);

/// The place of a phase in the list, or the size of the list. O(log phases).
[[nodiscard]] std::size_t place_of(const std::vector<PhaseArea>& areas, Phase phase);

} // namespace dsc
