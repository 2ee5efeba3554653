// SPDX-License-Identifier: MIT
#include "dsc3/operations/workspace.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <limits>

namespace dsc3 {

Real quality_of(const Complex& complex, std::uint32_t tet) {
    const auto& v = complex.tets[tet].v;
    return quality(complex.at(v[0]), complex.at(v[1]), complex.at(v[2]), complex.at(v[3]));
}

Real worst_quality(const Complex& complex, const Ring& ring) {
    Real worst = std::numeric_limits<Real>::max();
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        worst = std::min(worst, quality_of(complex, ring.tets[i]));
    }
    return worst;
}

} // namespace dsc3
