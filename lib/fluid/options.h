// SPDX-License-Identifier: MIT
// Options of a fluid: densities, viscosities, tensions, gravity and walls. Any consistent units can
// be used; the plane has no depth, so masses are per area and forces per length.
#pragma once

#include "dsc/dsc.h"

#include <functional>
#include <vector>

namespace dsc {

/// The fluid that fills a phase.
struct FluidPhase {
    Phase phase = exterior_phase; ///< which one
    double density = 1;           ///< mass per area, 0 or more
    double viscosity = 1;         ///< dynamic: stress times time, above 0
    /// No fluid; density and viscosity are ignored. Beside a void the fluids have a free surface
    /// with an outer pressure of 0.
    bool is_void = false;
};

/// The tension of the interface between two phases.
struct FluidTension {
    Phase one = exterior_phase; ///< either phase of the pair
    Phase other = 1;            ///< the other one
    double tension = 0;         ///< energy per length, 0 or more
    /// The contact angle between the interface and a slip wall, inside `other`: above 0 and below
    /// 180 degrees.
    double contact_angle = 90;
};

/// The kind of an edge of the domain boundary.
enum class Wall : std::uint8_t {
    no_slip, ///< the fluid moves with the wall, which rests unless there is a `wall_velocity`
    slip,    ///< the fluid slides without friction, and nothing flows through
    open,    ///< the fluid flows out, or in, without stress
};

/// The sides of the box around the domain, and the rest of its boundary.
struct Walls {
    Wall left = Wall::no_slip;   ///< at the smallest x
    Wall right = Wall::no_slip;  ///< at the largest x
    Wall bottom = Wall::no_slip; ///< at the smallest y
    Wall top = Wall::no_slip;    ///< at the largest y
    Wall other = Wall::no_slip;  ///< the boundary that is not on a side of the box
};

/// Which equations are solved.
enum class FluidEquations : std::uint8_t {
    navier_stokes, ///< with inertia; the fluid rests at the start
    stokes,        ///< without inertia: velocities follow from the interface
};

/// Options of a fluid.
struct FluidOptions {
    std::vector<FluidPhase> phases = {};     ///< each phase of the complex, in any order
    std::vector<FluidTension> tensions = {}; ///< each pair that meets, in any order
    Point<double> gravity{0.0, 0.0};         ///< acceleration
    Walls walls = {};                        ///< by side
    /// If set, it gives the kind of a boundary edge, by the edge's midpoint, instead of `walls`.
    std::function<Wall(const Point<double>& middle)> wall_at = {};
    /// If set, the velocity of walls without slip, by position and time: of moving walls, or of the
    /// inflow. Unless a part of the boundary is open, inflow and outflow must be equal.
    std::function<Point<double>(const Point<double>& place, double time)> wall_velocity = {};
    FluidEquations equations = FluidEquations::navier_stokes; ///< which are solved
    /// The tension acts at positions extrapolated by this fraction of the change of velocity in a
    /// step: from 0.5 on, tension does not limit the step. Larger values damp the shortest waves.
    double implicitness = 0.6;
    /// Target error per step of `Fluid::advance`, as a fraction of the edge length, up to 1; 0
    /// disables step control. The error of a step determines the length of the next one; a step
    /// with a larger error is not repeated.
    double tolerance = 0;
    std::uint32_t threads = 1; ///< 1 to 1024; does not change the results
};

/// Throws InputError if a value is out of range, a phase or a pair is named twice, or a tension
/// names a phase without properties. O(phases^2).
void check_fluid(const FluidOptions& options);

/// Density and viscosity of a phase. Throws InputError if it has none. O(phases).
[[nodiscard]] const FluidPhase& fluid_of(const FluidOptions& options, Phase phase);

/// The tension between two phases, in either order. Throws InputError if there is none: a tension
/// of 0 must be given explicitly. O(pairs).
[[nodiscard]] const FluidTension& pair_of(const FluidOptions& options, Phase one, Phase other);

} // namespace dsc
