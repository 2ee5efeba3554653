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
#pragma omp simd reduction(min : least)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real ax = ring.x[i] - px;
        const Real ay = ring.y[i] - py;
        const Real bx = ring.x_next[i] - px;
        const Real by = ring.y_next[i] - py;
        least = std::min(least, values.at[i] + slope * std::sqrt(ax * ax + ay * ay));
        least = std::min(least,
                         least_between<Real>(ax, ay, values.at[i], bx, by, values.next[i], slope));
    }
    if (!ring.closed) {
        least =
            std::min(least, values.at[ring.size] + slope * std::sqrt(ring.squared_edge(ring.size)));
    }
    return least;
}

template double least_over_link(const Ring<double>&, double, const LinkValues<double>&);
template float least_over_link(const Ring<float>&, float, const LinkValues<float>&);

} // namespace dsc
