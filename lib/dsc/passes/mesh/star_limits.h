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

/// The limits at a vertex with this target, inside a phase. O(1).
template <class Real>
StarLimits<Real> star_limits(const Options<Real>& options, Phase phase, Real length) {
    const PhaseThresholds& t = options.thresholds(phase);
    const auto square = [](Real value) { return value * value; };
    // The target grows along an edge that leads away from the interface: at the middle of one as
    // long as the threshold allows it is longer by this factor. Measured against the shorter target
    // of its ends alone, edges would be split and collapsed twice as often as they need.
    const double growth = options.sizes.growth > 0 ? options.sizes.growth : 1;
    const double stretch = 1 + 0.5 * t.longest * (growth - 1);
    return {square(static_cast<Real>(t.collapse_quality)),
            square(static_cast<Real>(t.smooth_quality)),
            square(static_cast<Real>(t.longest * stretch) * length),
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
