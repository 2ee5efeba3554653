// SPDX-License-Identifier: MIT
// Where a flow takes points, without any mesh: by the classical Runge-Kutta method with any number
// of steps.
#pragma once

#include "flows/velocity.h"

#include <functional>
#include <span>

namespace dsc::scenes {

/// Replaces each point by its image.
using FlowMap = std::function<void(std::span<Point<double>> points)>;

/// The solution of a flow from `begin` to `end`, by about `steps` steps of RK4; no step straddles
/// the end of a leg. Throws InputError unless begin <= end and steps >= 1.
[[nodiscard]] FlowMap runge_kutta_map(Flow flow, double begin, double end, int steps);

} // namespace dsc::scenes
