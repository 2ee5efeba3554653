// SPDX-License-Identifier: MIT
// Options of a fluid: densities, viscosities, tensions, gravity and walls. Any consistent units can
// be used; the plane has no depth, so masses are per area and forces per length.
#pragma once

#include "dsc/dsc.h"

#include <functional>
#include <string>
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

/// A straight edge of the domain with the name of its side.
struct DomainEdge {
    Point<double> from{0.0, 0.0}; ///< one end
    Point<double> to{0.0, 0.0};   ///< the other end
    /// Empty: by the side of the box around the domain, as in `Walls`.
    std::string side = {};
};

/// The condition on a side of the domain.
struct FluidSide {
    /// That of a `DomainEdge`; or `left`, `right`, `bottom`, `top` or `other`, as in `Walls`.
    std::string name;
    Wall wall = Wall::no_slip; ///< its kind
    /// If set, the velocity of a wall without slip, by position and time. Positions on a curved
    /// wall are those of vertices, of the middles of edges, and beside them on the curve.
    std::function<Point<double>(const Point<double>& place, double time)> velocity = {};
    /// If set, the speed at which the fluid flows in at a right angle, by position and time;
    /// negative where it flows out. Instead of `velocity`.
    std::function<double(const Point<double>& place, double time)> inflow = {};
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
    /// Conditions by name; they replace those of `walls` and `wall_velocity` on these sides. Where
    /// two sides without slip meet, the velocity is zero if it is zero on one of them, and else
    /// that of the first in this list.
    std::vector<FluidSide> sides = {};
    /// The edges of the domain with the names of their sides; empty: all are named by the box. An
    /// edge of the mesh is on the side of the domain's edge that is nearest to its midpoint.
    std::vector<DomainEdge> domain_edges = {};
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

/// Throws InputError if a value is out of range; a phase, a pair or a side is named twice; a
/// tension names a phase without properties; or the conditions of a side contradict each other.
/// O(phases^2).
void check_fluid(const FluidOptions& options);

/// Density and viscosity of a phase. Throws InputError if it has none. O(phases).
[[nodiscard]] const FluidPhase& fluid_of(const FluidOptions& options, Phase phase);

/// The tension between two phases, in either order. Throws InputError if there is none: a tension
/// of 0 must be given explicitly. O(pairs).
[[nodiscard]] const FluidTension& pair_of(const FluidOptions& options, Phase one, Phase other);

} // namespace dsc
