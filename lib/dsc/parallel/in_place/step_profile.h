// SPDX-License-Identifier: MIT
// Where the time of a step went, task by task: for the breakdown, for the picture of submeshes by
// their work, and for the model of more threads than the machine has. Measured only on request.
#pragma once

#include <cstdint>
#include <vector>

namespace dsc {

/// Seconds of a steady clock. On one thread of an idle machine that is the time of the task itself.
struct SubStepProfile {
    // Serial parts.
    double set_up = 0;    ///< cuts, lists and ids, before anything runs
    double hand_over = 0; ///< vertices that left their submesh
    double clean_up = 0;  ///< what all colours left, and updating the lists
    // By task.
    std::vector<double> aim;  ///< upkeep, velocities and targets: the first colour's submeshes
    std::vector<double> move; ///< movement and mesh update: all submeshes of all colours
    // Sums over submeshes.
    double upkeep = 0;                 ///< of the interface
    double velocities = 0;             ///< finding them, and the targets
    std::vector<double> motion_passes; ///< one entry for each motion pass, first colour
    double later_colours = 0;          ///< movement and mesh update of the colours after the first
    // Wall time of the two parallel sections.
    double aim_wall = 0;  ///< upkeep, velocities and targets
    double move_wall = 0; ///< movement and mesh update
};

/// All sub-steps of one step.
struct StepProfile {
    std::vector<SubStepProfile> sub_steps; ///< in their order
    double serial_outside = 0;             ///< the rest of the step: the driver's own
};

} // namespace dsc
