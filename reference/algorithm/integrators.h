// SPDX-License-Identifier: MIT
// From a velocity field to destinations: explicit Euler (thesis, section 5.1, equation 5), the
// midpoint rule (9.4) and the classical Runge-Kutta method of order four.
#pragma once

#include "dsc/base/types.h"

#include <functional>

namespace dsc::reference {

/// The velocity at a point and a time.
using Velocity = std::function<Point<double>(const Point<double>& p, double time)>;

enum class Integrator { euler, midpoint, rk4 };

/// The position of `p` after `dt`.
Point<double> advect(const Velocity& velocity, const Point<double>& p, double time, double dt,
                     Integrator integrator);

} // namespace dsc::reference
