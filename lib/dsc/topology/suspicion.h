// SPDX-License-Identifier: MIT
// Where the topology may have to change: a test on the star of an interface vertex that costs next
// to nothing, because the interface upkeep has gathered the star anyway.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/ring.h"

namespace dsc {

/// A vertex of the interface, where it was before the sub-step, and whether the topology may have
/// to change there.
template <class Real>
struct Suspect {
    Real x;               ///< before the sub-step
    Real y;               ///< before the sub-step
    std::uint32_t vertex; ///< its id
    bool is_thin;         ///< a triangle of its star is, or may be
    bool is_facing;       ///< one is, and the edge opposite to the vertex may be of the interface
    /// The interface turns sharply or tightly there, has a junction, or is beside the domain
    /// boundary.
    bool is_sharp;
    bool is_junction; ///< it turns sharply or has one, and not just between two edges inside
};

/// True if the smallest height of a triangle of the star is below the contact distance: its area
/// doubled is the height times the longest edge. In whole lanes; O(degree).
template <class Real>
[[nodiscard, gnu::always_inline]] inline bool has_thin_triangle(const Ring<Real>& ring,
                                                                Real contact_squared) {
    const Real x0 = ring.x0;
    const Real y0 = ring.y0;
    for (std::uint32_t first = 0; first < ring.size; first += Ring<Real>::lanes) {
        const Real* x = ring.x.data() + first;
        const Real* y = ring.y.data() + first;
        const Real* x_next = ring.x_next.data() + first;
        const Real* y_next = ring.y_next.data() + first;
        Real least = std::numeric_limits<Real>::max();
#pragma omp simd reduction(min : least)
        for (std::uint32_t i = 0; i < Ring<Real>::lanes; ++i) {
            const Real ax = x[i] - x0;
            const Real ay = y[i] - y0;
            const Real bx = x_next[i] - x0;
            const Real by = y_next[i] - y0;
            const Real doubled = ax * by - ay * bx;
            const Real cx = bx - ax;
            const Real cy = by - ay;
            const Real longest =
                std::max(std::max(ax * ax + ay * ay, bx * bx + by * by), cx * cx + cy * cy);
            least = std::min(least, doubled * doubled - contact_squared * longest);
        }
        if (least < 0) {
            return true;
        }
    }
    return false;
}

/// Whether two successive vertices of the link are of the interface: only then can an edge opposite
/// to the centre be one of its edges, and a triangle bridge a film. O(degree).
template <class Real>
[[nodiscard, gnu::always_inline]] inline bool may_face_a_sheet(const Complex<Real>& complex,
                                                               const Ring<Real>& ring) {
    const auto is_marked = [&](std::uint32_t i) {
        return (complex.vertices[ring.link[i]].flags & vertex_on_interface) != 0;
    };
    // Of two that are successive one has an odd place, unless they close an odd ring.
    const std::uint32_t n = ring.link_size();
    for (std::uint32_t i = 1; i < n; i += 2) {
        if (is_marked(i) &&
            (is_marked(i - 1) || (i + 1 < n ? is_marked(i + 1) : ring.closed && is_marked(0)))) {
            return true;
        }
    }
    return ring.closed && n % 2 == 1 && is_marked(n - 1) && is_marked(0);
}

} // namespace dsc
