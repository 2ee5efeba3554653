// SPDX-License-Identifier: MIT
// Triangles that are needles because they have a short interface edge: which of their edges the
// mesh update splits, so that edges grow gradually from a short one on.
#pragma once

#include "dsc/complex/ring.h"

namespace dsc {

/// A spoke to be split; `no_id` if there is none.
struct NeedleSpoke {
    std::uint32_t spoke = no_id;
    std::uint32_t base = no_id; ///< the spoke beside it that is the short interface edge
};

/// The longest spoke beside an interface edge of the star that is longer than the edge by more than
/// the grading, whose square is given. O(degree).
template <class Real>
NeedleSpoke needle_spoke(const Ring<Real>& ring, Real grading_squared) {
    Real longest = 0;
    NeedleSpoke found;
    const auto length = [&ring](std::uint32_t i) {
        const Real dx = ring.link_x(i) - ring.x0;
        const Real dy = ring.link_y(i) - ring.y0;
        return dx * dx + dy * dy;
    };
    const auto look_at = [&](std::uint32_t i, std::uint32_t beside, Real allowed) {
        const Real squared = length(i);
        if (squared > allowed && squared > longest && !ring.is_constrained(i)) {
            longest = squared;
            found = {i, beside};
        }
    };
    const std::uint32_t n = ring.link_size();
    for (std::uint32_t i = 0; i < n; ++i) {
        if (ring.is_constrained(i) && ring.phase_before(i) != border_phase &&
            ring.phase_after(i) != border_phase) {
            const Real allowed = grading_squared * length(i);
            if (i > 0 || ring.closed) {
                look_at(i > 0 ? i - 1 : n - 1, i, allowed);
            }
            if (i + 1 < n || ring.closed) {
                look_at(i + 1 < n ? i + 1 : 0, i, allowed);
            }
        }
    }
    return found;
}

} // namespace dsc
