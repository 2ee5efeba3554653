// SPDX-License-Identifier: MIT
#include "dsc/sizes/options.h"

#include "dsc/base/require.h"

#include <cmath>

namespace dsc {

template <class Real>
void check_sizes(const SizeOptions<Real>& sizes, Real edge_length) {
    require(sizes.growth == 0 || (sizes.growth > 1 && sizes.growth <= 2), "sizes.growth",
            sizes.growth, "0 (edges of one length), or above 1, up to 2");
    const auto longest = static_cast<double>(sizes.longest);
    require(longest == 0 || (std::isfinite(longest) && sizes.longest >= edge_length),
            "sizes.longest", longest, "0 (no bound), or a length of at least the edge length");
    const bool asks = longest != 0 || sizes.by_place || sizes.on_interface || sizes.by_distance ||
                      sizes.changes_in_time;
    require(!sizes.is_uniform() || !asks, "sizes.growth", sizes.growth,
            "above 1, up to 2, where another target is set");
    require(!sizes.changes_in_time || sizes.by_place || sizes.on_interface, "sizes.changes_in_time",
            1, "no, where there is no target by place");
}

template void check_sizes(const SizeOptions<double>&, double);
template void check_sizes(const SizeOptions<float>&, float);

} // namespace dsc
