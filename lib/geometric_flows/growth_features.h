// SPDX-License-Identifier: MIT
// The features of an interface that grows along its normal (growth.h): fans where they open,
// notches where sheets run into each other.
#pragma once

#include "dsc/passes/algorithm.h"
#include "geometric_flows/growth.h"

namespace dsc {

/// A pass of remeshing, to run after that of the interface. At a feature that opens it puts a fan
/// of vertices: beside the feature at first, on their rays as soon as there is room. It puts
/// vertices that remeshing inserts between two of them on the arc. It marks notches as features,
/// and removes vertices in the way of a notch. If the flow has reversed and a fan has shrunk to
/// less than a sub-step, the fan becomes a notch again. O(interface vertices). Expects
/// `add_fan_rays`.
template <class Real>
[[nodiscard]] Pass<Real> growth_features(const GrowthOptions<Real>& options);

/// The default algorithm and that pass; adds the attribute of rays to the complex:
///
///     const GrowthOptions<double> options{.speeds = {{1, 0, 1.0}}};
///     Simulation<double> simulation(
///         complex, numbers, make_executor(complex, numbers, Parallel{.threads = 2},
///                                         growth_algorithm(complex, options)));
///     simulation.step(growth(options), time, dt);
///
/// Throws InputError if an option is out of range or names a phase that the complex does not have.
/// O(n), once.
template <class Real>
[[nodiscard]] Algorithm<Real> growth_algorithm(Complex<Real>& complex,
                                               const GrowthOptions<Real>& options);

} // namespace dsc
