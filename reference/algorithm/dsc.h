// SPDX-License-Identifier: MIT
// The deformable simplicial complex, sequential and literal: thesis algorithms 5.1 and 5.2 and
// section 8.10.
#pragma once

#include "reference/algorithm/integrators.h"
#include "reference/algorithm/movement.h"
#include "reference/algorithm/passes.h"
#include "reference/complex/complex.h"

#include <cstddef>

namespace dsc::reference {

/// Which vertices the velocity moves (thesis, section 9.1): those of the interface, or also those
/// inside phases other than the exterior.
enum class Moving { interface, interior_too };

struct Options {
    PassOptions passes;
    Integrator integrator = Integrator::rk4;
    Moving moving = Moving::interface;
    double substep = 0.5;     ///< no vertex is asked to travel further at a time, h
    int max_substeps = 10000; ///< a step that needs more is refused
    int max_iterations = 20;  ///< of the loop of algorithm 5.1, in each sub-step
    int max_repairs = 2;      ///< more of them, without movement, while a triangle is poor
};

/// What a step did.
struct StepCounts : PassCounts {
    std::size_t moved = 0;      ///< moves that arrived, summed over the sub-steps
    std::size_t unreached = 0;  ///< vertices that were blocked, or whose velocity is not finite
    std::size_t iterations = 0; ///< of the loop of algorithm 5.1, summed over the sub-steps
    std::size_t substeps = 0;
};

/// Algorithm 5.1: moves the vertices to their destinations and keeps the mesh in shape. `I` is
/// Interface(K). What is left in `destinations` could not be reached within `max_iterations`.
void dsc(Complex& K, const SimplexSet& I, Destinations& destinations, const Options& options,
         StepCounts& counts);

/// One time step from `time` to `time + dt`. A vertex whose velocity is not finite is held and
/// counted as unreached; one on the domain boundary slides along it. Throws InputError for a step
/// that is not finite or would need more than `max_substeps`.
StepCounts step(Complex& K, const Velocity& velocity, double time, double dt,
                const Options& options = {});

} // namespace dsc::reference
