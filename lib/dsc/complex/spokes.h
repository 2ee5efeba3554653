// SPDX-License-Identifier: MIT
// Which spokes of a gathered star belong to the interface.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/ring.h"

namespace dsc {

/// The interface spokes of a ring; more than two make a junction.
struct Spokes {
    std::uint32_t count = 0;  ///< how many there are
    std::uint32_t first = 0;  ///< counter-clockwise from the ring's first spoke; if count > 0
    std::uint32_t second = 0; ///< the last one where there are more than two; if count > 1

    /// Of two spokes, the one that is not `spoke`.
    [[nodiscard]] std::uint32_t other(std::uint32_t spoke) const {
        return first == spoke ? second : first;
    }
};

/// The spokes whose two sides differ in phase. O(degree).
template <class Real>
Spokes interface_spokes(const Ring<Real>& ring) {
    Spokes spokes;
    const std::uint32_t n = ring.link_size();
    Phase before = ring.phase_before(0);
    for (std::uint32_t i = 0; i < n; ++i) {
        const Phase after = ring.phase_after(i);
        if (before != after && is_interface_pair(before, after)) {
            (spokes.count == 0 ? spokes.first : spokes.second) = i;
            ++spokes.count;
        }
        before = after;
    }
    return spokes;
}

/// Where link vertex i is; also the last one of an open star.
template <class Real>
Point<Real> link_point(const Ring<Real>& ring, std::uint32_t i) {
    return {ring.link_x(i), ring.link_y(i)};
}

} // namespace dsc
