// SPDX-License-Identifier: MIT
// What the mesh update asks of a star: the thresholds of its phase, at the target length of edges
// there.
#pragma once

#include "dsc/passes/options.h"
#include "dsc/quality/ring_quality.h"

namespace dsc {

/// All squared, as stars are examined.
template <class Real>
struct StarLimits {
    Real collapse; ///< quality
    Real smooth;   ///< quality
    Real longest;  ///< length
    Real shortest; ///< length
    Real crowded;  ///< length
};

template <class Real>
StarLimits<Real> star_limits(const PhaseThresholds& t, Real length) {
    const auto square = [](Real value) { return value * value; };
    return {square(static_cast<Real>(t.collapse_quality)),
            square(static_cast<Real>(t.smooth_quality)),
            square(static_cast<Real>(t.longest) * length),
            square(static_cast<Real>(t.shortest) * length),
            square(static_cast<Real>(t.crowded) * length)};
}

/// Whether the lengths of the spokes call for an edit.
template <class Real>
bool is_out_of_size(const StarReport<Real>& star, const StarLimits<Real>& limits) {
    return star.longest > limits.longest || star.shortest < limits.shortest ||
           star.longest < limits.crowded;
}

} // namespace dsc
