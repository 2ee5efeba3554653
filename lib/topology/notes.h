// SPDX-License-Identifier: MIT
// Notes: what changes of topology need to know of each interface vertex before anything moves, its
// position and properties of its star. A pass at the end of remeshing writes the notes to an
// attribute, in all submeshes at the same time; the change of topology reads them after the
// sub-step.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"

#include <cmath>
#include <numbers>

namespace dsc {

/// The notes on a star, as bits.
enum Notable : std::uint32_t {
    noted_sharp = 1U,    ///< `Candidate::is_sharp`
    noted_junction = 2U, ///< `Candidate::is_junction`
    /// Two sheets of the interface met at the vertex in this sub-step or an earlier one; kept from
    /// round to round.
    noted_seam = 4U,
    noted_star = 8U,    ///< the star has been examined in this round
    noted_change = 16U, ///< the topology has changed at the vertex since it was last noted
};

/// The note of a vertex.
struct Note {
    std::uint32_t round = 0; ///< of the sub-step; 0: none yet
    std::uint32_t what = 0;  ///< bits of `Notable`
};

/// Archives a note.
inline void archive(Archive& archive, Note& note) { archive(note.round, note.what); }

/// Where a vertex was. A type of its own, because attributes of points count as data of the
/// application and are written to files.
template <class Real>
struct NotedPlace {
    Real x = 0; ///< in units of the domain
    Real y = 0; ///< in units of the domain
};

/// Archives a noted position.
template <class Real>
void archive(Archive& archive, NotedPlace<Real>& place) {
    archive(place.x, place.y);
}

/// Whether the complex has an attribute of notes. O(1).
template <class Real>
[[nodiscard]] bool has_notes(const Complex<Real>& complex);
/// The notes of a complex, created if there are none yet. A new vertex between two noted ones
/// counts as noted. O(1), or O(n) for new ones.
template <class Real>
[[nodiscard]] VertexAttribute<Note>& notes_of(Complex<Real>& complex);
/// The positions before the sub-step of the vertices noted last. As `notes_of`.
template <class Real>
[[nodiscard]] VertexAttribute<NotedPlace<Real>>& places_of(Complex<Real>& complex);
/// Clears all notes, such as those of an earlier simulation, and how far vertices are ahead of the
/// time. O(n).
template <class Real>
void begin_notes(Complex<Real>& complex);

/// Every closed curve around an area A has a curvature of sqrt(pi / A) or more somewhere. Half of
/// that also covers curves that end on the sides of a corner of the domain, and unequal edges.
template <class Real>
[[nodiscard]] Real curvature_around(Real min_area) {
    return std::sqrt(std::numbers::pi_v<Real> / min_area) / 2;
}

/// The arrays of notes of a complex. Each entry has one writer, the work that lists the vertex.
template <class Real>
struct Notebook {
    VertexAttribute<Note>* notes;              ///< of `notes_of`
    VertexAttribute<NotedPlace<Real>>* places; ///< of `places_of`
};

/// Writes the notes on the star of an interface vertex, which has just been gathered. `curvature`:
/// from which on the outline may be that of a small piece. O(1).
template <class Real>
void note_star(const Work<Real>& work, const Star<Real>& star, const IncidentEdges& incident,
               Real curvature, std::uint32_t round, const Notebook<Real>& book);

/// Writes the notes of a work's interface vertices: a pass without edits. Skips stars that have
/// been noted in this round and have not changed since. O(interface vertices of the work), plus the
/// degrees of those noted here.
template <class Real>
void note_stars(Work<Real>& work, Real curvature, std::uint32_t round);

// --- tests of a star -----------------------------------------------------------------------------

/// The two edges of a curve at a vertex, as vectors along the curve.
template <class Real>
struct Bend {
    /// The bend at the second of three successive points.
    Bend(Real from_x, Real from_y, Real x, Real y, Real to_x, Real to_y)
        : in_x(x - from_x), in_y(y - from_y), out_x(to_x - x), out_y(to_y - y) {}
    /// The bend of the interface at the centre of a star.
    Bend(const Star<Real>& star, const IncidentEdges& incident)
        : Bend(star.link_x(incident.first), star.link_y(incident.first), star.x0, star.y0,
               star.link_x(incident.second), star.link_y(incident.second)) {}

    Real in_x;  ///< to the vertex
    Real in_y;  ///< as in_x
    Real out_x; ///< from the vertex
    Real out_y; ///< as out_x
};

/// Whether the interface turns by more than 45 degrees between two edges: the angle from which an
/// outline counts as sharp. Compares squares, since a root would take a third of the time.
template <class Real>
[[nodiscard]] bool turns_sharply(const Bend<Real>& bend) {
    constexpr Real squared_cosine = Real(0.49);
    const Real along = bend.in_x * bend.out_x + bend.in_y * bend.out_y;
    return !(along > 0 && along * along > squared_cosine *
                                              (bend.in_x * bend.in_x + bend.in_y * bend.in_y) *
                                              (bend.out_x * bend.out_x + bend.out_y * bend.out_y));
}

/// Whether the circle through the ends of both edges has at least that curvature. Both sides are
/// squared and dimensionless, because a product of three squared lengths may underflow.
template <class Real>
[[nodiscard]] bool turns_tightly(const Bend<Real>& bend, Real curvature) {
    const Real a_x = bend.in_x * curvature;
    const Real a_y = bend.in_y * curvature;
    const Real b_x = bend.out_x * curvature;
    const Real b_y = bend.out_y * curvature;
    const Real c_x = a_x + b_x;
    const Real c_y = a_y + b_y;
    const Real sine = a_x * b_y - a_y * b_x;
    return 4 * sine * sine >=
           (a_x * a_x + a_y * a_y) * (b_x * b_x + b_y * b_y) * (c_x * c_x + c_y * c_y);
}

} // namespace dsc
