// SPDX-License-Identifier: MIT
#include "dsc3/complex/ownership.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc3 {

Real CutTree::distance(const Point& p) const {
    Real nearest = std::numeric_limits<Real>::infinity();
    std::uint32_t node = 1;
    for (std::uint32_t level = 0; level < levels; ++level) {
        const Real beyond = p[axes[node]] - cuts[node];
        nearest = std::min(nearest, std::abs(beyond));
        node = 2 * node + (beyond >= 0 ? 1U : 0U);
    }
    return nearest;
}

Label Ownership::label_at(const Point& p) const {
    Label label = partition ? partition(p) % submeshes : trees[0].cell(p);
    for (std::uint32_t colour = 1; colour < colour_count; ++colour) {
        label |= trees[colour].cell(p) << (8 * colour);
    }
    return label;
}

} // namespace dsc3
