// SPDX-License-Identifier: MIT
// Two equal viscous cylinders coalesce in a void, without inertia: the exact solution of R. W.
// Hopper, "Plane Stokes flow driven by capillarity on a free surface" (1990). The final shape is a
// disc of radius 1 around the origin; lengths are in units of this radius, and times in units of
// viscosity times radius over tension.
#pragma once

#include "dsc/base/types.h"

namespace dsc::scenes {

/// A point of the outline. `m` falls from 1 (two discs that touch at the origin) to 0 (one disc).
/// Angle 0 is the neck, on the x axis, and a right angle the end of a cylinder, on the y axis.
[[nodiscard]] Point<double> coalescing_outline(double m, double angle);

/// The distance of the neck from the origin.
[[nodiscard]] double coalescing_neck(double m);

/// The time of the outline of `m`, above 0 and below 1. The relative error is below 1e-12.
[[nodiscard]] double coalescing_time(double m);

/// The `m` of a neck between 0 and 1.
[[nodiscard]] double coalescing_at_neck(double neck);
/// The `m` of a time above 0.
[[nodiscard]] double coalescing_at_time(double time);

} // namespace dsc::scenes
