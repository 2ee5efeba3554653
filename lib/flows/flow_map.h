// SPDX-License-Identifier: MIT
// The motion of points by a flow, without a mesh: a Runge-Kutta method of order 8 with any number
// of steps.
#pragma once

#include "flows/velocity.h"

#include <functional>
#include <span>

namespace dsc::scenes {

/// Replaces each point by its image.
using FlowMap = std::function<void(std::span<Point<double>> points)>;

/// The solution of a flow from `begin` to `end`, by about `steps` steps of 13 velocities each, of
/// order 8 (E. Fehlberg, "Classical fifth-, sixth-, seventh-, and eighth-order Runge-Kutta formulas
/// with stepsize control", NASA TR R-287, 1968); no step straddles the end of a leg.
[[nodiscard]] FlowMap runge_kutta_map(Flow flow, double begin, double end, int steps);

} // namespace dsc::scenes
