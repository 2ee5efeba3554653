// SPDX-License-Identifier: MIT
// From a velocity field to target positions. All vertices are evaluated in one call.
#pragma once

#include "dsc/motion/integrator.h"
#include "dsc3/base/types.h"

#include <functional>
#include <span>
#include <vector>

namespace dsc3 {

/// velocities[i] = v(positions[i], time). A vertex whose velocity is not finite stays and is
/// counted.
using Velocity =
    std::function<void(std::span<const Point> positions, Real time, std::span<Point> velocities)>;

/// A velocity that is called once in each stage of the integrator, with all interface vertices, by
/// the thread that calls `Simulation::step`: for a function that is expensive to call, such as one
/// written in Python. The result is bitwise identical to that of the plain velocity.
struct VelocityAtOnce {
    Velocity velocity; ///< of positions and time
};

using dsc::Integrator;

/// Scratch arrays of an integrator, reused to avoid allocation.
struct IntegratorScratch {
    std::vector<Point> first; ///< v(positions, time), set by the caller
    std::vector<Point> stage; ///< positions of a stage
    std::vector<Point> slope; ///< velocities of a stage
    std::vector<Point> sum;   ///< of the weighted velocities
};

/// targets[i] = positions[i] advected to time + dt. `scratch.first` must hold the velocities at
/// (positions, time). Returns the largest finite estimate of the error of this step, a length; 0
/// for all methods except `adaptive`. `fixed` has the fixed coordinates of each position
/// (`vertex_fixed_x`, ...), which no stage changes; empty: there are none. O(n).
Real integrate(Integrator integrator, const Velocity& velocity, std::span<const Point> positions,
               Real time, Real dt, std::span<Point> targets, IntegratorScratch& scratch,
               std::span<const std::uint32_t> fixed = {});

/// Velocities along the sides: their fixed coordinates become 0.
void keep_on_sides(std::span<Point> velocities, std::span<const std::uint32_t> fixed);

} // namespace dsc3
