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

/// The vertices moved by the velocity (thesis, section 9.1): those of the interface, or also those
/// inside phases other than the exterior.
enum class Moving { interface, interior_too };

struct Options {
    PassOptions passes;
    Integrator integrator = Integrator::rk4;
    Moving moving = Moving::interface;
    double substep = 0.5;     ///< largest displacement in a sub-step, in h
    int max_substeps = 10000; ///< steps that need more are refused
    int max_iterations = 20;  ///< of the loop of algorithm 5.1, in each sub-step
    int max_repairs = 2;      ///< additional iterations without movement while a triangle is poor
};

/// The counts of a step.
struct StepCounts : PassCounts {
    std::size_t moved = 0;      ///< moves that arrived, summed over the sub-steps
    std::size_t unreached = 0;  ///< vertices that were blocked, or whose velocity is not finite
    std::size_t iterations = 0; ///< of the loop of algorithm 5.1, summed over the sub-steps
    std::size_t substeps = 0;
};

/// Algorithm 5.1: moves the vertices to their destinations and maintains the mesh. `I` is
/// Interface(K). Destinations not reached within `max_iterations` remain in `destinations`.
void dsc(Complex& K, const SimplexSet& I, Destinations& destinations, const Options& options,
         StepCounts& counts);

/// One time step from `time` to `time + dt`. A vertex whose velocity is not finite stays and is
/// counted as unreached; a vertex on the domain boundary slides along it. Throws InputError for a
/// step that is not finite or would need more than `max_substeps`.
StepCounts step(Complex& K, const Velocity& velocity, double time, double dt,
                const Options& options = {});

} // namespace dsc::reference
