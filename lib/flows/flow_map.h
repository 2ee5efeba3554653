// SPDX-License-Identifier: MIT
// Where a flow takes points, without any mesh: in closed form if there is one, otherwise by the
// classical Runge-Kutta method with any number of steps.
#pragma once

#include "flows/velocity.h"

#include <functional>
#include <span>

namespace dsc::scenes {

/// Replaces each point by its image.
using FlowMap = std::function<void(std::span<Point<double>> points)>;

[[nodiscard]] FlowMap translation_map(const Point<double>& displacement);
/// A rotation counter-clockwise, by an angle in radians.
[[nodiscard]] FlowMap rotation_map(const Point<double>& centre, double angle);
/// The solution of Radial after a time, for points that do not reach the centre.
[[nodiscard]] FlowMap radial_map(const Radial& field, double time);
/// The solution of Vortex after a time: each circle turns rigidly.
[[nodiscard]] FlowMap vortex_map(const Vortex& field, double time);

/// The solution of a flow from `begin` to `end`, by about `steps` steps of RK4; no step straddles
/// the end of a leg. Throws InputError unless begin <= end and steps >= 1.
[[nodiscard]] FlowMap runge_kutta_map(Flow flow, double begin, double end, int steps);

} // namespace dsc::scenes
