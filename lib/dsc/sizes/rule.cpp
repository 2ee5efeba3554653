// SPDX-License-Identifier: MIT
// Compiled without errno for square roots (CMakeLists.txt): the loop over the lanes has them.
#include "dsc/sizes/rule.h"

namespace dsc {

template <class Real>
Real least_over_link(const Ring<Real>& ring, Real slope, const LinkValues<Real>& values) {
    Real least = std::numeric_limits<Real>::infinity();
    const std::uint32_t n = ring.closed ? ring.padded() : ring.size;
    const Real px = ring.x0;
    const Real py = ring.y0;
    const Real* x = ring.x.data();
    const Real* y = ring.y.data();
    const Real* x_next = ring.x_next.data();
    const Real* y_next = ring.y_next.data();
    const Real* at = values.at.data();
    const Real* next = values.next.data();
#pragma omp simd reduction(min : least)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real ax = x[i] - px;
        const Real ay = y[i] - py;
        const Real bx = x_next[i] - px;
        const Real by = y_next[i] - py;
        least = std::min(least, at[i] + slope * std::sqrt(ax * ax + ay * ay));
        least = std::min(least, least_between<Real>(ax, ay, at[i], bx, by, next[i], slope));
    }
    if (!ring.closed) {
        least = std::min(least, at[ring.size] + slope * std::sqrt(ring.squared_spoke(ring.size)));
    }
    return least;
}

template double least_over_link(const Ring<double>&, double, const LinkValues<double>&);
template float least_over_link(const Ring<float>&, float, const LinkValues<float>&);

} // namespace dsc
