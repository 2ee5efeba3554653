// SPDX-License-Identifier: MIT
// What flows: densities, viscosities, tensions, gravity and walls. Any consistent units will do;
// the plane has no depth, so that masses are per area and forces per length.
#pragma once

#include "dsc/dsc.h"

#include <vector>

namespace dsc {

/// The fluid that fills a phase.
struct FluidPhase {
    Phase phase = exterior_phase; ///< which one
    double density = 1;           ///< mass per area, 0 or more
    double viscosity = 1;         ///< dynamic: stress times time, above 0
    /// No fluid at all, whatever the properties say: beside it the others have a free surface, with
    /// a pressure of 0 outside.
    bool is_void = false;
};

/// The tension of the interface between two phases.
struct FluidTension {
    Phase one = exterior_phase; ///< either phase of the pair
    Phase other = 1;            ///< the other one
    double tension = 0;         ///< energy per length, 0 or more
    /// Between the interface and a wall that slips, inside `other`: above 0 and below 180 degrees.
    double contact_angle = 90;
};

/// How a fluid moves at a side of the domain. Nothing flows through it.
enum class Wall : std::uint8_t {
    no_slip, ///< it rests there
    slip,    ///< it slides along without friction
};

/// The sides of the domain.
struct Walls {
    Wall left = Wall::no_slip;   ///< at the smallest x
    Wall right = Wall::no_slip;  ///< at the largest x
    Wall bottom = Wall::no_slip; ///< at the smallest y
    Wall top = Wall::no_slip;    ///< at the largest y
};

/// Which equations are solved.
enum class FluidEquations : std::uint8_t {
    navier_stokes, ///< with inertia; the fluid rests at the start
    stokes,        ///< without: velocities follow from where the interface is
};

/// All that an application chooses for a fluid.
struct FluidOptions {
    std::vector<FluidPhase> phases = {};     ///< each phase of the complex, in any order
    std::vector<FluidTension> tensions = {}; ///< each pair that meets, in any order
    Point<double> gravity{0.0, 0.0};         ///< acceleration
    Walls walls = {};                        ///< by side
    FluidEquations equations = FluidEquations::navier_stokes; ///< which are solved
    /// The tension is taken at places that are ahead by this share of what the new velocity changes
    /// in a step: from 0.5 on, no tension limits the step. More damps the shortest waves.
    double implicitness = 0.6;
    /// Error per step that `Fluid::advance` aims at, as a share of the edge length, up to 1; 0
    /// disables step control. The length of a step is chosen from the error of the one before; a
    /// step that exceeds it is kept.
    double tolerance = 0;
    std::uint32_t threads = 1; ///< 1 to 1024; any number gives the same bits
};

/// Throws InputError if a value is out of range, a phase or a pair is named twice, or a tension
/// names a phase without properties. O(phases^2).
void check_fluid(const FluidOptions& options);

/// Density and viscosity of a phase. Throws InputError if it has none. O(phases).
[[nodiscard]] const FluidPhase& fluid_of(const FluidOptions& options, Phase phase);

/// The tension between two phases, in either order. Throws InputError if there is none, since a
/// tension that was forgotten would look like one of zero. O(pairs).
[[nodiscard]] const FluidTension& pair_of(const FluidOptions& options, Phase one, Phase other);

} // namespace dsc
