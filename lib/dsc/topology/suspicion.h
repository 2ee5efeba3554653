// SPDX-License-Identifier: MIT
// Where the topology may have to change: a test on the star of an interface vertex that costs next
// to nothing, because the interface upkeep has gathered the star anyway.
#pragma once

#include "dsc/complex/ring.h"

namespace dsc {

/// An interface vertex at which the topology may have to change, and where it was before the
/// sub-step.
template <class Real>
struct Suspect {
    std::uint32_t vertex; ///< its id
    Real x;               ///< before the sub-step
    Real y;               ///< before the sub-step
    bool is_thin;         ///< a triangle of its star is
    bool is_sharp;        ///< the interface turns sharply there, or has a junction
};

/// True if the smallest height of a triangle of the star is below the contact distance: its area
/// doubled is the height times the longest edge. All lanes at once; O(degree).
template <class Real>
[[nodiscard]] bool has_thin_triangle(const Ring<Real>& ring, Real contact_squared) {
    Real least = std::numeric_limits<Real>::max();
    const std::uint32_t n = ring.padded();
    const Real* x = ring.x.data();
    const Real* y = ring.y.data();
    const Real* x_next = ring.x_next.data();
    const Real* y_next = ring.y_next.data();
#pragma omp simd reduction(min : least)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real ax = x[i] - ring.x0;
        const Real ay = y[i] - ring.y0;
        const Real bx = x_next[i] - ring.x0;
        const Real by = y_next[i] - ring.y0;
        const Real doubled = ax * by - ay * bx;
        const Real cx = bx - ax;
        const Real cy = by - ay;
        const Real longest =
            std::max(std::max(ax * ax + ay * ay, bx * bx + by * by), cx * cx + cy * cy);
        least = std::min(least, doubled * doubled - contact_squared * longest);
    }
    return least < 0;
}

} // namespace dsc
