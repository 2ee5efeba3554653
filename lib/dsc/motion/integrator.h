// SPDX-License-Identifier: MIT
// From a velocity field to target positions (thesis, section 5.1, equation 5). All vertices are
// evaluated in one call, so that a field pays its overhead once and can use all lanes.
#pragma once

#include "dsc/base/enum_table.h"
#include "dsc/base/types.h"

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace dsc {

/// velocities[i] = v(positions[i], time). Called from several threads at once by the parallel
/// driver: it must not change shared state. NaN or infinity: the vertex is held and counted.
template <class Real>
using Velocity = std::function<void(std::span<const Point<Real>> positions, Real time,
                                    std::span<Point<Real>> velocities)>;

/// How targets are found from velocities.
enum class Integrator : std::uint8_t {
    euler,    ///< first order, one evaluation a step
    midpoint, ///< second order, two evaluations
    rk4,      ///< fourth order, four evaluations
    adaptive, ///< rk4 with an estimate of its error, from which the step is chosen; five. It
              ///< does not notice a velocity that is equal everywhere and changes in time
};

inline constexpr std::array integrator_names{
    Named{Integrator::euler, "euler"},
    Named{Integrator::midpoint, "midpoint"},
    Named{Integrator::rk4, "rk4"},
    Named{Integrator::adaptive, "adaptive"},
};

[[nodiscard]] constexpr std::string_view to_string(Integrator integrator) {
    return name_in(integrator_names, integrator);
}

/// Arrays that an integrator needs; kept from step to step so that nothing is allocated.
template <class Real>
struct IntegratorScratch {
    std::vector<Point<Real>> first; ///< v(positions, time), as the caller leaves it
    std::vector<Point<Real>> stage; ///< positions of a stage
    std::vector<Point<Real>> slope; ///< velocities of a stage
    std::vector<Point<Real>> sum;   ///< of the weighted velocities
};

/// targets[i] = where positions[i] is at time + dt. `scratch.first` must hold the velocities at
/// (positions, time), which the driver needs to choose its sub-step. Returns the largest finite
/// estimate of the error of this step, a length; 0 for all methods except `adaptive`. O(n).
template <class Real>
Real integrate(Integrator integrator, const Velocity<Real>& velocity,
               std::span<const Point<Real>> positions, Real time, Real dt,
               std::span<Point<Real>> targets, IntegratorScratch<Real>& scratch);

} // namespace dsc
