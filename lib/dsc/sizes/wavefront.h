// SPDX-License-Identifier: MIT
// How a value that grows with the distance reaches a point: along edges, or across the triangles of
// its star, which is exact for a straight front (R. Kimmel, J. A. Sethian, "Computing geodesic
// paths on manifolds", 1998).
#pragma once

#include "dsc/complex/ring.h"

#include <cmath>
#include <limits>

namespace dsc {

/// The least of value(q) + slope |p - q| over the points q strictly between a and b, where the
/// value is linear; infinity if it is at an end, or if the values at both ends are infinite. (ax,
/// ay) and (bx, by) lead from p to a and b. `slope` must be positive. Without branches.
template <class Real>
Real least_between(Real ax, Real ay, Real value_a, Real bx, Real by, Real value_b, Real slope) {
    const Real ex = bx - ax;
    const Real ey = by - ay;
    const Real squared = ex * ex + ey * ey;
    const Real along = -(ax * ex + ay * ey);
    const Real across = std::abs(ax * by - ay * bx);
    // How far the front rises along the edge, and how far it goes sideways: 0 where it is steeper
    // than the slope, and the lower end always the better start.
    const Real rise = (value_b - value_a) / slope;
    const Real sideways = std::sqrt(std::max(Real(0), squared - rise * rise));
    const Real foot = along * sideways - across * rise; // over sideways: along the edge
    const Real value = value_a + slope * (rise * along + sideways * across) / squared;
    // A choice between constants: between computed values it would become a branch, and a loop over
    // lanes no loop over vectors.
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const Real bound = std::min(foot, squared * sideways - foot) > 0 ? -infinity : infinity;
    return std::max(bound, value);
}

/// The values at the link of a ring: as the ring's coordinates, padded, with those of the next link
/// vertex beside them.
template <class Real>
struct LinkValues {
    alignas(64) std::array<Real, Ring<Real>::room> at;   ///< of link vertex i
    alignas(64) std::array<Real, Ring<Real>::room> next; ///< of link vertex i + 1

    /// Takes value(v) of each vertex v of the link. O(degree).
    template <class Value>
    void take(const Ring<Real>& ring, Value value) {
        const std::uint32_t n = ring.size;
        at[0] = value(ring.link[0]);
        for (std::uint32_t i = 1; i <= n; ++i) { // the last one of an open ring is not padding
            const Real there = value(ring.link[i]);
            at[i] = there;
            next[i - 1] = there;
        }
        for (std::uint32_t i = n; i < ring.padded(); ++i) {
            at[i + 1] = at[0];
            next[i] = next[0];
        }
    }
};

/// The least of value(q) + slope |p - q| over the points q of the link of a ring, whose centre is
/// p; the value is linear along the link's edges. O(degree).
template <class Real>
Real least_over_link(const Ring<Real>& ring, Real slope, const LinkValues<Real>& values);

} // namespace dsc
