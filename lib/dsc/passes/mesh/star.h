// SPDX-License-Identifier: MIT
// Properties of a star for the mesh update: the thresholds of its phase for the local target
// length; the edges to be split at needles; and the triangles after a collapse.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"
#include "dsc/passes/options.h"
#include "dsc/quality/measures.h"

#include <algorithm>

namespace dsc {

/// Qualities and lengths are squared, as stars are examined.
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
    // The target grows along an edge that leads away from the interface: at the middle of the
    // longest edge allowed it is larger by this factor. If only the smaller target of its ends
    // counted, edges would be split and collapsed twice as often as necessary.
    const double growth = options.sizes.growth > 0 ? options.sizes.growth : 1;
    const double stretch = 1 + 0.5 * t.longest * (growth - 1);
    return {square(static_cast<Real>(t.collapse_quality)),
            square(static_cast<Real>(t.smooth_quality)),
            square(static_cast<Real>(t.longest * stretch) * length),
            square(static_cast<Real>(t.shortest) * length),
            square(static_cast<Real>(t.crowded) * length)};
}

/// Whether the lengths of the incident edges call for an edit.
template <class Real>
bool is_out_of_size(const StarReport<Real>& star, const StarLimits<Real>& limits) {
    return star.longest > limits.longest || star.shortest < limits.shortest ||
           star.longest < limits.crowded;
}

/// An incident edge to be split; `no_id` if there is none.
struct NeedleEdge {
    std::uint32_t incident_edge = no_id;
    std::uint32_t base = no_id; ///< the short interface edge beside it
};

/// The longest incident edge beside an interface edge of the star that is longer than the edge by
/// more than the grading, whose square is given. O(degree).
template <class Real>
NeedleEdge needle_edge(const Star<Real>& star, Real grading_squared) {
    Real longest = 0;
    NeedleEdge found;
    const auto look_at = [&](std::uint32_t i, std::uint32_t beside, Real allowed) {
        const Real squared = star.squared_edge(i);
        if (squared > allowed && squared > longest && !star.is_constrained(i)) {
            longest = squared;
            found = {i, beside};
        }
    };
    const std::uint32_t n = star.link_size();
    for (std::uint32_t i = 0; i < n; ++i) {
        if (star.is_constrained(i) && star.phase_before(i) != border_phase &&
            star.phase_after(i) != border_phase) {
            const Real allowed = grading_squared * star.squared_edge(i);
            if (i > 0 || star.closed) {
                look_at(i > 0 ? i - 1 : n - 1, i, allowed);
            }
            if (i + 1 < n || star.closed) {
                look_at(i + 1 < n ? i + 1 : 0, i, allowed);
            }
        }
    }
    return found;
}

/// The longest edge, squared, from link vertex i to the others: that of the triangles after the
/// centre is collapsed into vertex i. O(degree).
template <class Real>
Real longest_after_collapse(const Star<Real>& star, std::uint32_t i) {
    Real longest = 0;
    for (std::uint32_t j = 0; j < star.size; ++j) {
        const Real dx = star.x[j] - star.x[i];
        const Real dy = star.y[j] - star.y[i];
        longest = std::max(longest, dx * dx + dy * dy);
    }
    return longest;
}

/// Whether no needle beside an interface edge would be split again at once, with the star's
/// triangles at link vertex i. `grading_squared`: how much longer than that edge an edge may be,
/// squared; 0: without a limit. The star must be closed. O(degree).
template <class Real>
bool keeps_grading(const Complex<Real>& complex, const Star<Real>& star, Real grading_squared,
                   std::uint32_t i) {
    if (grading_squared == 0) {
        return true;
    }
    const std::uint32_t n = star.size;
    const auto squared = [](Real dx, Real dy) { return dx * dx + dy * dy; };
    for (std::uint32_t j = 0; j < n; ++j) {
        const Phase across = complex.phase_at(complex.twin(star.corner[j]));
        if (across == star.phase[j] || across == border_phase) {
            continue;
        }
        // The apex over this edge: i, or the next vertex of the link where i is one of its ends.
        const std::uint32_t end = j + 1 == n ? 0 : j + 1;
        const std::uint32_t apex = i == j     ? (end + 1 == n ? 0 : end + 1)
                                   : i == end ? (j == 0 ? n - 1 : j - 1)
                                              : i;
        // Some slack, so that collapses and splits do not alternate.
        const Real allowed = Real(0.8) * grading_squared *
                             squared(star.x_next[j] - star.x[j], star.y_next[j] - star.y[j]);
        if (squared(star.x[apex] - star.x[j], star.y[apex] - star.y[j]) > allowed ||
            squared(star.x[apex] - star.x[end], star.y[apex] - star.y[end]) > allowed) {
            return false;
        }
    }
    return true;
}

} // namespace dsc
