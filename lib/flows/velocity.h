// SPDX-License-Identifier: MIT
// The velocity fields of the thesis's experiments (thesis, sections 9.1 to 9.6) and the single
// vortex that is common in the literature. They are structs that evaluate a batch of positions at
// once; any of them is a Velocity.
#pragma once

#include "dsc/base/types.h"

#include <functional>
#include <span>
#include <vector>

namespace dsc::scenes {

/// The positions of a batch, and the velocities to be written: equally many, possibly in the same
/// memory.
using Positions = std::span<const Point<double>>;
using Velocities = std::span<Point<double>>;

/// Writes the velocity at each position at one time. Safe to call from several threads at once.
using Velocity = std::function<void(Positions positions, double time, Velocities velocities)>;

/// Equation 7: the same velocity everywhere.
struct Translation {
    Point<double> velocity{0.0, 0.0};
    void operator()(Positions positions, double time, Velocities velocities) const;
};

/// Equation 8: away from a centre at a constant speed; zero at the centre itself.
struct Radial {
    Point<double> centre{0.0, 0.0};
    double speed = 1.0;
    void operator()(Positions positions, double time, Velocities velocities) const;
};

/// Equation 9: counter-clockwise around a centre at a constant angular speed (radians per time).
struct Rotation {
    Point<double> centre{0.0, 0.0};
    double angular_speed = 1.0;
    void operator()(Positions positions, double time, Velocities velocities) const;
};

/// Equation 10: counter-clockwise around a centre at a constant speed; zero at the centre itself.
struct Vortex {
    Point<double> centre{0.0, 0.0};
    double speed = 1.0;
    void operator()(Positions positions, double time, Velocities velocities) const;
};

/// The field of the stream function of equation 11, times a factor:
///     v = amplitude f(t) (sin^2(pi x) sin(2 pi y), -sin^2(pi y) sin(2 pi x)).
/// This is its true derivative; the thesis's equation 13 keeps a stray 1/pi. f is 1, or
/// cos(pi t / period) if a period is given: R. J. LeVeque's reversing flow, "High-resolution
/// conservative algorithms for advection in incompressible flow" (1996).
struct Swirl {
    double amplitude = 1.0;
    double period = 0.0; ///< time from start to return; 0 for a steady flow
    void operator()(Positions positions, double time, Velocities velocities) const;
};

/// Straight down towards a surface where the velocity vanishes:
///     v = (0, -speed tanh((y - surface) / depth)).
struct Falling {
    double surface = 0.0;
    double depth = 1.0; ///< the flow slows down below this height above the surface
    double speed = 1.0; ///< far above the surface
    void operator()(Positions positions, double time, Velocities velocities) const;
    /// The point advected for this time: sinh((y - surface) / depth) decays as exp(-time speed /
    /// depth).
    [[nodiscard]] Point<double> advected(const Point<double>& point, double time) const;
};

/// The opposite flow.
[[nodiscard]] Velocity reversed(Velocity velocity);

/// A velocity that applies until a time.
struct Leg {
    double end = 0.0;
    Velocity velocity;
};

/// A sequence of velocities. A whole step belongs to one leg, because at the exact time of a change
/// the velocity cannot depend on whether a step ends or begins there, and a Runge-Kutta step with
/// the wrong velocity would lose its order.
using Flow = std::vector<Leg>;

/// One velocity for all times.
[[nodiscard]] Flow steady(Velocity velocity);
/// `velocity` until `half_time`, and then its opposite.
[[nodiscard]] Flow there_and_back(const Velocity& velocity, double half_time);

/// The velocity of the leg that contains the middle of this step; after the end, that of the last
/// leg. Throws InputError for a flow without legs.
[[nodiscard]] const Velocity& velocity_of_step(const Flow& flow, double begin, double end);

} // namespace dsc::scenes
