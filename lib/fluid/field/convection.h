// SPDX-License-Identifier: MIT
// Inertia by following particles backwards (Lagrange-Galerkin): O. Pironneau, "On the
// transport-diffusion algorithm and its applications to the Navier-Stokes equations" (1982), with
// the backward difference of second order.
#pragma once

#include "fluid/field/snapshot_field.h"

namespace dsc {

/// The last two solutions.
struct FluidPast {
    const FluidField* one = nullptr; ///< the last one
    const FluidField* two = nullptr; ///< the field before that; null: there is none
};

/// The derivative in time along the path of a particle as
/// now * u(time) + one * u(one's time) + two * u(two's time): second order in the duration of the
/// steps, which may differ; first order without a `two`.
struct BackwardDifference {
    double now = 0; ///< 1 / time
    double one = 0; ///< 1 / time
    double two = 0; ///< 1 / time; 0 without this solution
};

/// The weights for `time`, which is later than the past. O(1).
[[nodiscard]] BackwardDifference backward_difference(const FluidPast& past, double time);

/// The velocity at a point: extrapolated in time from both fields, or that of the only one. The
/// searches begin at the vertex `near`. O(1) if it is nearby.
[[nodiscard]] Point<double> extrapolated_velocity(const FluidPast& past, const Point<double>& at,
                                                  double time, std::uint32_t near);

/// The velocity, one step ago, of the particle that is now at the vertex with this id.
[[nodiscard]] Point<double> last_velocity(const FluidPast& past, const Point<double>& at,
                                          double time, std::uint32_t near);

/// The contribution of the past to the derivative at the points of `points_of_degree_5` of a
/// triangle of `mesh`: one * u(one's time) + two * u(two's time). O(1) if the searches are short.
[[nodiscard]] std::array<Point<double>, 7> past_accelerations(const MeshSnapshot& mesh,
                                                              const SnapshotTriangle& triangle,
                                                              const FluidPast& past, double time);

} // namespace dsc
