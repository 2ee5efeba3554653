// SPDX-License-Identifier: MIT
// Names the vertices of the interface as the upkeep visits them with their stars, and says at which
// of them the topology may have to change.
#pragma once

#include "dsc/passes/interface/curve.h"
#include "dsc/passes/work.h"
#include "dsc/topology/suspicion.h"

namespace dsc {

/// Marks a living vertex as one of the interface, or no longer one: `may_face_a_sheet` reads it.
/// O(1).
template <class Real>
void mark_interface(Complex<Real>& complex, std::uint32_t v, bool is_on_interface) {
    std::uint32_t& flags = complex.vertices[v].flags;
    if (is_on_interface != ((flags & vertex_on_interface) != 0) && (flags & vertex_dead) == 0) {
        flags ^= vertex_on_interface;
    }
}

/// Names the centre of a star of the interface, and says whether there is a film, the end of a
/// seam, or a small piece, whose outline turns sharply or ends soon. `contact`: the largest contact
/// distance; `is_known`: the star is as it was gathered, and nobody else writes to it. O(degree).
template <class Real>
void suspect(Work<Real>& work, const Ring<Real>& ring, const Spokes& spokes, Real contact,
             bool is_known) {
    constexpr Real sharp = Real(0.7);
    // Nearly no star of the interface faces a sheet. Which of the others are thin matters once
    // something else has changed: they are looked at then.
    const bool may_face = !is_known || may_face_a_sheet(work.complex, ring);
    const bool is_thin = may_face ? has_thin_triangle(ring, contact * contact) : spokes.count > 0;
    const bool is_sharp =
        spokes.count > 2 ||
        (spokes.count == 2 && !turns_less<Real>(link_point(ring, spokes.first), {ring.x0, ring.y0},
                                                link_point(ring, spokes.second), sharp));
    if (is_thin || is_sharp) {
        work.topology_suspects.push_back(
            {ring.vertex, ring.x0, ring.y0, is_thin, is_thin && may_face, is_sharp});
    }
}

} // namespace dsc
