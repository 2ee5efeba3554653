// SPDX-License-Identifier: MIT
// Small waves between two viscous fluids that start from rest: the initial-value problem of A.
// Prosperetti, "Motion of two superposed viscous fluids" (1981), for any two fluids: for a level
// interface between two walls, and for a drop in an unbounded fluid.
#pragma once

#include "fluid/options.h"

#include <functional>

namespace dsc::scenes {

/// Two fluids and the interface between them.
struct TwoFluids {
    FluidPhase inside;  ///< the drop, or the fluid below
    FluidPhase outside; ///< the fluid around the drop, or above
    double tension = 0;
};

/// The height over time of a wave cos(k x) on a level interface half-way between two slip walls at
/// distance `depth`. It is `first` at the start. `gravity` acts towards the fluid inside. The
/// relative error is below 1e-6 up to a time of 30 over the frequency.
[[nodiscard]] std::function<double(double time)>
wave_on_level(const TwoFluids& fluids, double k, double depth, double gravity, double first);

/// The same for a wave cos(n angle), n from 2 on, around a drop of this radius.
[[nodiscard]] std::function<double(double time)> wave_on_drop(const TwoFluids& fluids, int n,
                                                              double radius, double first);

} // namespace dsc::scenes
