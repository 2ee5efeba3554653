// SPDX-License-Identifier: MIT
// Names the vertices of the interface as the upkeep visits them with their stars, and says at which
// of them the topology may have to change.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/passes/interface/curve.h"
#include "dsc/passes/work.h"
#include "dsc/topology/suspicion.h"

#include <cmath>
#include <numbers>
#include <span>

namespace dsc {

/// Marks a living vertex as one of the interface or the domain boundary, or as neither:
/// `may_face_a_sheet` reads it.
/// O(1).
template <class Real>
void mark_interface(Complex<Real>& complex, std::uint32_t v, bool is_on_interface) {
    std::uint32_t& flags = complex.vertices[v].flags;
    if (is_on_interface != ((flags & vertex_on_interface) != 0) && (flags & vertex_dead) == 0) {
        flags ^= vertex_on_interface;
    }
}

/// After edits that were made in the whole complex, between two steps: of the changed vertices
/// those of the interface and the domain boundary are marked, and no other, and those around them
/// may no longer be plain.
/// O(their stars); not thread-safe.
template <class Real>
void renew_marks(Complex<Real>& complex, std::span<const std::uint32_t> changed) {
    for (const std::uint32_t v : changed) {
        if (!complex.is_alive(Vertex{v})) {
            continue;
        }
        bool is_on_interface = false;
        for_each_corner(complex, Vertex{v}, [&](Corner c) {
            for (const Corner at : {c, next(c), prev(c)}) {
                complex.vertices[complex.vertex(at)].flags &= ~std::uint32_t{vertex_plain};
            }
            const Corner across = complex.twin(next(c));
            is_on_interface = is_on_interface || is_border(across) ||
                              is_interface_pair(complex.phase_at(c), complex.phase_at(across));
        });
        mark_interface(complex, v, is_on_interface);
    }
}

/// No vertex is known to be plain, and those of the domain boundary are marked: a film may lie
/// along it. O(mesh).
template <class Real>
void forget_plain(Complex<Real>& complex) {
    for (auto& vertex : complex.vertices) {
        vertex.flags &= ~std::uint32_t{vertex_plain};
    }
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            if (is_border(complex.twin(c))) {
                mark_interface(complex, complex.vertex(next(c)), true);
                mark_interface(complex, complex.vertex(prev(c)), true);
            }
        }
    }
}

/// Whether a star has two interface edges, inside the domain, whose ends are not neighbours.
template <class Real>
[[nodiscard, gnu::always_inline]] inline bool is_simple(const Ring<Real>& ring,
                                                        const Spokes& spokes) {
    const std::uint32_t between = spokes.second - spokes.first;
    return spokes.count == 2 && ring.closed && between != 1 && between + 1 != ring.size;
}

/// Whether the link has a vertex of the interface beside the ends of the two spokes, or these two
/// are neighbours, or there are not two. Where it is false, as nearly everywhere, the star faces no
/// sheet. O(degree).
template <class Real>
[[nodiscard]] bool meets_interface_elsewhere(const Complex<Real>& complex, const Ring<Real>& ring,
                                             const Spokes& spokes) {
    if (!is_simple(ring, spokes)) {
        return true;
    }
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        if (i != spokes.first && i != spokes.second &&
            (complex.vertices[ring.link[i]].flags & vertex_on_interface) != 0) {
            return true;
        }
    }
    return false;
}

/// Whether a turn is by more than the angle at which an outline counts as sharp. Squared: the root
/// of `turns_less` would be a third of the time that the topology takes.
template <class Real>
[[nodiscard, gnu::always_inline]] inline bool is_sharp_turn(Real in_x, Real in_y, Real out_x,
                                                            Real out_y) {
    constexpr Real squared_cosine = Real(0.49);
    const Real along = in_x * out_x + in_y * out_y;
    return !(along > 0 && along * along > squared_cosine * (in_x * in_x + in_y * in_y) *
                                              (out_x * out_x + out_y * out_y));
}

/// Whether the interface turns by more than that at the centre of a star.
template <class Real>
[[nodiscard]] bool turns_sharply(const Ring<Real>& ring, const Spokes& spokes) {
    return is_sharp_turn(ring.x0 - ring.link_x(spokes.first), ring.y0 - ring.link_y(spokes.first),
                         ring.link_x(spokes.second) - ring.x0,
                         ring.link_y(spokes.second) - ring.y0);
}

/// What makes a star suspicious.
template <class Real>
struct Suspicious {
    Real contact;   ///< the largest contact distance
    Real curvature; ///< from here on, the outline may be that of a small piece
};

/// Of every closed curve around an area A, the curvature is somewhere sqrt(pi / A) or more. Half of
/// that includes what a corner of the domain completes, and unequal edges.
template <class Real>
[[nodiscard]] Real curvature_around(Real least_area) {
    return std::sqrt(std::numbers::pi_v<Real> / least_area) / 2;
}

/// Whether the circle through both ends and the vertex between two edges has that curvature, or
/// more. Both sides are squared, and without a unit: see `is_sharp_turn`.
template <class Real>
[[nodiscard, gnu::always_inline]] inline bool is_tight_turn(Real in_x, Real in_y, Real out_x,
                                                            Real out_y, Real curvature) {
    const Real a_x = in_x * curvature;
    const Real a_y = in_y * curvature;
    const Real b_x = out_x * curvature;
    const Real b_y = out_y * curvature;
    const Real c_x = a_x + b_x;
    const Real c_y = a_y + b_y;
    const Real sine = a_x * b_y - a_y * b_x;
    return 4 * sine * sine >=
           (a_x * a_x + a_y * a_y) * (b_x * b_x + b_y * b_y) * (c_x * c_x + c_y * c_y);
}

/// Whether the interface bends by that much at the centre of a star.
template <class Real>
[[nodiscard]] bool turns_tightly(const Ring<Real>& ring, const Spokes& spokes, Real curvature) {
    return is_tight_turn(ring.x0 - ring.link_x(spokes.first), ring.y0 - ring.link_y(spokes.first),
                         ring.link_x(spokes.second) - ring.x0, ring.link_y(spokes.second) - ring.y0,
                         curvature);
}

/// Whether a curve ends on the domain boundary at the centre, or, if `may_face`, an edge of the
/// link lies there. O(degree).
template <class Real>
[[nodiscard]] bool is_at_wall(const Complex<Real>& complex, const Ring<Real>& ring,
                              const Spokes& spokes, bool may_face) {
    if (!ring.closed) {
        return spokes.first != 0 || spokes.second != ring.size;
    }
    if (!may_face) {
        return false;
    }
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        if (is_border(complex.twin(ring.corner[i]))) {
            return true;
        }
    }
    return false;
}

/// Names the centre of a star at which there may be a film, the end of a seam, or a small piece,
/// whose outline turns sharply or tightly, or ends soon. O(degree).
template <class Real>
[[gnu::noinline]] void suspect_in_full(Work<Real>& work, const Ring<Real>& ring,
                                       const Spokes& spokes, const Suspicious<Real>& what,
                                       bool is_known) {
    bool may_face = true;
    if (is_known) {
        const bool meets = meets_interface_elsewhere(work.complex, ring, spokes);
        std::uint32_t& flags = work.complex.vertices[ring.vertex].flags;
        if (meets == ((flags & vertex_plain) != 0) && (meets || work.has_marks)) {
            flags ^= vertex_plain;
        }
        may_face = meets && may_face_a_sheet(work.complex, ring);
    }
    // Which of the stars that face no sheet are thin matters once something else has changed: they
    // are looked at then.
    const bool is_thin =
        may_face ? has_thin_triangle(ring, what.contact * what.contact) : spokes.count > 0;
    const bool is_sharp = spokes.count > 2 || (spokes.count == 2 && turns_sharply(ring, spokes));
    const bool is_notable =
        is_sharp || (spokes.count == 2 && (turns_tightly(ring, spokes, what.curvature) ||
                                           is_at_wall(work.complex, ring, spokes, may_face)));
    if (is_thin || is_notable) {
        work.topology_suspects.push_back(
            {.x = ring.x0,
             .y = ring.y0,
             .vertex = ring.vertex,
             .is_thin = is_thin,
             .is_facing = is_thin && may_face,
             .is_sharp = is_notable,
             .is_junction = is_sharp && (spokes.count != 2 || !ring.closed)});
    }
}

/// Names the centre of a star of the interface, and says what may be there. `is_known`: the star is
/// as it was gathered, and nobody else writes to it. Nearly every star is plain and not sharp: it
/// takes no look at the link, no vectors, and no calls, for which registers would have to be saved.
/// O(degree).
template <class Real>
void suspect(Work<Real>& work, const Ring<Real>& ring, const Spokes& spokes,
             const Suspicious<Real>& what, bool is_known) {
    auto& list = work.topology_suspects;
    const bool is_plain = (work.complex.vertices[ring.vertex].flags & vertex_plain) != 0;
    const std::uint32_t from = spokes.first;
    const std::uint32_t to = spokes.second;
    const Real in_x = ring.x0 - ring.x[from];
    const Real in_y = ring.y0 - ring.y[from];
    const Real out_x = ring.x[to] - ring.x0;
    const Real out_y = ring.y[to] - ring.y0;
    if (!is_known || !is_plain || !is_simple(ring, spokes) ||
        is_sharp_turn(in_x, in_y, out_x, out_y) ||
        is_tight_turn(in_x, in_y, out_x, out_y, what.curvature) || list.size() == list.capacity()) {
        suspect_in_full(work, ring, spokes, what, is_known);
        return;
    }
    list.push_back({.x = ring.x0,
                    .y = ring.y0,
                    .vertex = ring.vertex,
                    .is_thin = true,
                    .is_facing = false,
                    .is_sharp = false,
                    .is_junction = false});
}

} // namespace dsc
