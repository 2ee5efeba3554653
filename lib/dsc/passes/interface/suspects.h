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

/// Whether the link has a vertex of the interface beside the ends of the two spokes, or these two
/// are neighbours, or there are not two. Where it is false, as nearly everywhere, the star faces no
/// sheet. O(degree).
template <class Real>
[[nodiscard, gnu::always_inline]] inline bool
meets_interface_elsewhere(const Complex<Real>& complex, const Ring<Real>& ring,
                          const Spokes& spokes) {
    const std::uint32_t between = spokes.second - spokes.first;
    if (spokes.count != 2 || !ring.closed || between == 1 || between + 1 == ring.size) {
        return true;
    }
    const auto has_mark = [&](std::uint32_t i, std::uint32_t end) {
        for (; i < end; ++i) {
            if ((complex.vertices[ring.link[i]].flags & vertex_on_interface) != 0) {
                return true;
            }
        }
        return false;
    };
    return has_mark(spokes.first + 1, spokes.second) || has_mark(0, spokes.first) ||
           has_mark(spokes.second + 1, ring.size);
}

/// Whether the interface turns by more than the angle at which an outline counts as sharp. Squared:
/// the root of `turns_less` would be a third of the time that the topology takes.
template <class Real>
[[nodiscard, gnu::always_inline]] inline bool turns_sharply(const Ring<Real>& ring,
                                                            const Spokes& spokes) {
    constexpr Real squared_cosine = Real(0.49);
    const Real in_x = ring.x0 - ring.link_x(spokes.first);
    const Real in_y = ring.y0 - ring.link_y(spokes.first);
    const Real out_x = ring.link_x(spokes.second) - ring.x0;
    const Real out_y = ring.link_y(spokes.second) - ring.y0;
    const Real along = in_x * out_x + in_y * out_y;
    return !(along > 0 && along * along > squared_cosine * (in_x * in_x + in_y * in_y) *
                                              (out_x * out_x + out_y * out_y));
}

/// Names the centre of a star at which there may be a film, the end of a seam, or a small piece,
/// whose outline turns sharply or ends soon. O(degree).
template <class Real>
[[gnu::noinline]] void suspect_in_full(Work<Real>& work, const Ring<Real>& ring,
                                       const Spokes& spokes, Real contact, bool is_known) {
    // Which of the stars that face no sheet are thin matters once something else has changed: they
    // are looked at then.
    const bool may_face = !is_known || may_face_a_sheet(work.complex, ring);
    const bool is_thin = may_face ? has_thin_triangle(ring, contact * contact) : spokes.count > 0;
    const bool is_sharp = spokes.count > 2 || (spokes.count == 2 && turns_sharply(ring, spokes));
    if (is_thin || is_sharp) {
        work.topology_suspects.push_back(
            {.x = ring.x0,
             .y = ring.y0,
             .vertex = ring.vertex,
             .is_thin = is_thin,
             .is_facing = is_thin && may_face,
             .is_sharp = is_sharp,
             .is_junction = is_sharp && (spokes.count != 2 || !ring.closed)});
    }
}

/// Names the centre of a star of the interface, and says what may be there. `contact`: the largest
/// contact distance; `is_known`: the star is as it was gathered, and nobody else writes to it.
/// Nearly no star faces a sheet or is sharp: the others get by without vectors, and the registers
/// that these would have to save. O(degree).
template <class Real>
void suspect(Work<Real>& work, const Ring<Real>& ring, const Spokes& spokes, Real contact,
             bool is_known) {
    if (!is_known || meets_interface_elsewhere(work.complex, ring, spokes) ||
        turns_sharply(ring, spokes)) {
        suspect_in_full(work, ring, spokes, contact, is_known);
        return;
    }
    work.topology_suspects.push_back({.x = ring.x0,
                                      .y = ring.y0,
                                      .vertex = ring.vertex,
                                      .is_thin = true,
                                      .is_facing = false,
                                      .is_sharp = false,
                                      .is_junction = false});
}

} // namespace dsc
