// SPDX-License-Identifier: MIT
// The edits that passes make: an operation with its guard, which then puts the vertices whose stars
// must be visited into the active set. A pass is then candidates, guard, edit. Passes of an
// application may use the public operations instead, with `work.submesh`: their edits are then read
// from the log (readers.h).
#pragma once

#include "dsc/base/verdict.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"

namespace dsc {

/// Puts the link of the centre into the active set, counter-clockwise. O(degree).
template <class Real>
void activate_link(Work<Real>& work, const Star<Real>& star) {
    const std::uint32_t n = star.link_size();
    for (std::uint32_t i = 0; i < n; ++i) {
        work.activate(star.link[i]);
    }
}

/// Collapses the edge opposite to `corner` and activates the link; the centre of the star is the
/// vanishing end.
template <class Real>
Verdict collapse_centre(Work<Real>& work, const Star<Real>& star, Corner corner,
                        rewire::Vanishing end) {
    const Verdict verdict = edge_collapse(work.submesh, corner, end, BoundaryRule::smooth);
    if (verdict == Verdict::legal) {
        activate_link(work, star);
    }
    return verdict;
}

/// Collapses the centre into link vertex i, if the centre is inside one phase and its whole star is
/// owned: only inversion can prevent it (`star_collapse_guard`).
template <class Real>
Verdict collapse_star(Work<Real>& work, const Star<Real>& star, std::uint32_t i) {
    const Verdict verdict = star_collapse_guard(work.complex, star, i);
    if (verdict == Verdict::legal) {
        rewire::collapse(work.complex, work.log, prev(star.corner[i]), rewire::Vanishing::next,
                         *work.submesh.pool);
        activate_link(work, star);
    }
    return verdict;
}

/// The vertices that are activated after a split.
enum class Wake : std::uint8_t {
    far_end, ///< the new vertex, and the end of the edge that is not being visited
    all,     ///< the new vertex, and those of the two triangles
};

/// Splits the edge opposite to `corner` at `point`. The vertex at next(corner) is the one being
/// visited.
template <class Real>
SplitResult split(Work<Real>& work, Corner corner, const Point<Real>& point, Wake wake) {
    const Complex<Real>& complex = work.complex;
    const Corner across = complex.twin(corner);
    const std::uint32_t near = complex.vertex(next(corner));
    const std::uint32_t far = complex.vertex(prev(corner));
    const std::uint32_t left = complex.vertex(corner);
    const std::uint32_t right = is_border(across) ? no_id : complex.vertex(across);
    const SplitResult result = edge_split(work.submesh, corner, point);
    if (result.verdict != Verdict::legal) {
        return result;
    }
    work.activate(result.vertex.id);
    if (wake == Wake::all) {
        work.activate(near);
    }
    work.activate(far);
    if (wake == Wake::all) {
        work.activate(left);
        if (right != no_id) {
            work.activate(right);
        }
    }
    return result;
}

/// Whether an edit refused with this verdict is left to another submesh or to a later colour.
constexpr bool is_deferred(Verdict verdict) {
    return verdict == Verdict::out_of_ids || verdict == Verdict::on_submesh_boundary;
}

} // namespace dsc
