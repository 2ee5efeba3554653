// SPDX-License-Identifier: MIT
// Compiled without errno for square roots (CMakeLists.txt), so that the loop over the lanes becomes
// vector code.
#include "dsc/sizes/rule.h"

namespace dsc {

template <class Real>
Real min_over_link(const Star<Real>& star, Real slope, const LinkValues<Real>& values) {
    Real smallest = std::numeric_limits<Real>::infinity();
    const std::uint32_t n = star.closed ? star.padded() : star.size;
    const Real px = star.x0;
    const Real py = star.y0;
#pragma omp simd reduction(min : smallest)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real ax = star.x[i] - px;
        const Real ay = star.y[i] - py;
        const Real bx = star.x_next[i] - px;
        const Real by = star.y_next[i] - py;
        smallest = std::min(smallest, values.at[i] + slope * std::sqrt(ax * ax + ay * ay));
        smallest = std::min(smallest,
                            min_between<Real>(ax, ay, values.at[i], bx, by, values.next[i], slope));
    }
    if (!star.closed) {
        smallest = std::min(smallest,
                            values.at[star.size] + slope * std::sqrt(star.squared_edge(star.size)));
    }
    return smallest;
}

template double min_over_link(const Star<double>&, double, const LinkValues<double>&);
template float min_over_link(const Star<float>&, float, const LinkValues<float>&);

} // namespace dsc
