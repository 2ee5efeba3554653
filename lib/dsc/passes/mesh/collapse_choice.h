// SPDX-License-Identifier: MIT
// What a collapse of a star would leave behind: the mesh update asks before it chooses the
// neighbour that takes the star.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/ring.h"

#include <algorithm>

namespace dsc {

/// The longest edge, squared, from link vertex i to the others: that of its triangles after the
/// centre has gone there. O(degree).
template <class Real>
Real longest_after_collapse(const Ring<Real>& ring, std::uint32_t i) {
    Real longest = 0;
    for (std::uint32_t j = 0; j < ring.size; ++j) {
        const Real dx = ring.x[j] - ring.x[i];
        const Real dy = ring.y[j] - ring.y[i];
        longest = std::max(longest, dx * dx + dy * dy);
    }
    return longest;
}

/// Whether no needle beside an interface edge would be split again at once, with the star's
/// triangles at link vertex i. `grading_squared`: how much longer than that edge an edge may be,
/// squared; 0: without a limit. The ring must be closed. O(degree).
template <class Real>
bool keeps_grading(const Complex<Real>& complex, const Ring<Real>& ring, Real grading_squared,
                   std::uint32_t i) {
    if (grading_squared == 0) {
        return true;
    }
    const std::uint32_t n = ring.size;
    const auto squared = [](Real dx, Real dy) { return dx * dx + dy * dy; };
    for (std::uint32_t j = 0; j < n; ++j) {
        const Phase across = complex.phase_at(complex.twin(ring.corner[j]));
        if (across == ring.phase[j] || across == border_phase) {
            continue;
        }
        // The apex over this edge: i, or beyond it where i is one of its ends.
        const std::uint32_t end = j + 1 == n ? 0 : j + 1;
        const std::uint32_t apex = i == j     ? (end + 1 == n ? 0 : end + 1)
                                   : i == end ? (j == 0 ? n - 1 : j - 1)
                                              : i;
        // Some slack, so that a collapse and a split do not take turns.
        const Real allowed = Real(0.8) * grading_squared *
                             squared(ring.x_next[j] - ring.x[j], ring.y_next[j] - ring.y[j]);
        if (squared(ring.x[apex] - ring.x[j], ring.y[apex] - ring.y[j]) > allowed ||
            squared(ring.x[apex] - ring.x[end], ring.y[apex] - ring.y[end]) > allowed) {
            return false;
        }
    }
    return true;
}

} // namespace dsc
