// SPDX-License-Identifier: MIT
// Walks along the outline of a phase, and the state of changes of topology. Functions that edit are
// serial and rare: they run between two sub-steps, on a few triangles, in the whole complex.
// Functions that only read are called by several threads at the same time.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/rewire.h"
#include "dsc/geometry/points.h"
#include "dsc/motion/time_ahead.h"
#include "topology/candidates.h"
#include "topology/events.h"
#include "topology/notes.h"
#include "topology/options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace dsc {

/// An area that one phase has lost to another.
struct Transfer {
    Phase from;          ///< which lost it
    Phase to;            ///< which gained it
    double area;         ///< above 0
    Point<double> place; ///< where it lay
    Triangle near;       ///< a triangle there
};

/// A vertex that did not arrive before the stages changed anything. It may have arrived since, or
/// another vertex may have its id: then its noted place is another.
template <class Real>
struct Missed {
    std::uint32_t vertex;    ///< its id
    Point<Real> target;      ///< where it was to go
    NotedPlace<Real> before; ///< where it came from
};

/// The state that changes of topology work on.
template <class Real>
struct TopologyWork {
    Complex<Real>& complex;                        ///< is changed
    const TopologyOptions<Real>& options;          ///< of the stage
    Real edge_length;                              ///< of the interface
    double time;                                   ///< of the events
    Real dt = 1;                                   ///< of the sub-step
    std::vector<Event>& events;                    ///< what happens is appended
    std::span<const std::uint32_t> interface = {}; ///< its vertices
    std::uint32_t round = 0;                       ///< of the notes on them
    bool is_again = false; ///< stages have edited the complex since the notes were made
    const InShares& in_shares = one_by_one;           ///< the threads of the step
    VertexAttribute<Note>& notes = notes_of(complex); ///< on each star
    /// Where the vertices were when the notes were made.
    const VertexAttribute<NotedPlace<Real>>& places = places_of(complex);
    /// Vertices of triangles that changed their phase, and those that edges were contracted to;
    /// some may now have too many sectors, or slender triangles.
    std::vector<Vertex> touched = {};
    std::vector<Transfer> transfers = {};      ///< recorded if area must be given back
    std::span<const Missed<Real>> missed = {}; ///< in the movement of this sub-step, ascending
    /// How far the vertices are ahead of the time.
    VertexAttribute<TimeAhead<Real>>& ahead = times_ahead_of(complex);
    double swept = 0; ///< area, by merged junctions; the next event reports it
    /// The candidates that were blocked before the change, ascending.
    std::vector<std::uint32_t> blocked = {};
};

/// Whether a vertex that is not noted may have come onto the interface since the notes were made.
/// O(1).
template <class Real>
[[nodiscard]] bool may_be_new(const TopologyWork<Real>& work, Vertex v) {
    return work.is_again || (work.notes[v].what & noted_change) != 0;
}

/// Notes a change at the vertex: its star may need to be mended.
template <class Real>
void touch(TopologyWork<Real>& work, Vertex v) {
    work.notes[v].what |= noted_change;
    work.touched.push_back(v);
}

/// Whether the domain ends at the vertex. O(degree).
template <class Real>
[[nodiscard]] bool is_on_boundary(const Complex<Real>& complex, Vertex v) {
    return find_corner(complex, v, [&](Corner c) {
               return is_border(complex.twin(next(c))) || is_border(complex.twin(prev(c)));
           }) != no_id;
}

/// Whether the half-edge has another phase, or the outside of the domain, on its right. O(1).
template <class Real>
[[nodiscard]] bool is_outline(const Complex<Real>& complex, Corner c) {
    return complex.phase_at(complex.twin(c)) != complex.phase_at(c);
}

/// Whether the half-edge has another phase of the domain on its right.
template <class Real>
[[nodiscard]] bool is_sheet(const Complex<Real>& complex, Corner c) {
    return is_interface_pair(complex.phase_at(c), complex.phase_at(complex.twin(c)));
}

/// Whether more than two sheets meet at the vertex. O(degree).
template <class Real>
[[nodiscard]] bool is_junction(const Complex<Real>& complex, Vertex v) {
    int sheets = 0;
    return find_corner(complex, v, [&](Corner c) {
               sheets += is_sheet(complex, prev(c)) ? 1 : 0;
               return sheets > 2;
           }) != no_id;
}

/// Whether a triangle at the vertex has the phase. O(degree).
template <class Real>
[[nodiscard]] bool has_phase(const Complex<Real>& complex, std::uint32_t v, Phase phase) {
    return find_corner(complex, Vertex{v},
                       [&](Corner c) { return complex.phase_at(c) == phase; }) != no_id;
}

/// Whether fronts of different phases that displace this one meet in points (meeting.h): those that
/// grow into the exterior do. A thin phase among others is a grain that vanishes; it is relabelled.
[[nodiscard]] constexpr bool meet_in_points(Phase film) { return film == exterior_phase; }

/// Whether fronts displace the film. Where phases keep their areas, fronts displace nothing: the
/// stage gives back the area that they take. O(1).
template <class Real>
[[nodiscard]] bool is_displaced(const TopologyWork<Real>& work, Phase film) {
    return meet_in_points(film) && !work.options.gives_back_area;
}

/// The phase on the right of the half-edge.
template <class Real>
[[nodiscard]] Phase phase_beyond(const Complex<Real>& complex, Corner c) {
    return complex.phase_at(complex.twin(c));
}

/// The contact distance of two phases; 0 if their interface must stay. O(pairs).
template <class Real>
[[nodiscard]] Real contact_of(const TopologyWork<Real>& work, Phase one, Phase other) {
    const auto rule = rule_of(work.options, work.edge_length, one, other);
    return rule.rule == Topology::change ? rule.contact : Real(0);
}

/// The contact distance at a half-edge; 0 if it must stay, as the domain boundary does. O(pairs).
template <class Real>
[[nodiscard]] Real contact_at(const TopologyWork<Real>& work, Corner sheet) {
    const Phase beyond = phase_beyond(work.complex, sheet);
    return beyond != border_phase && beyond != work.complex.phase_at(sheet)
               ? contact_of(work, work.complex.phase_at(sheet), beyond)
               : Real(0);
}

/// A contact distance as single triangles span it: the default instead of a wide one.
template <class Real>
[[nodiscard]] Real within_triangles(const TopologyWork<Real>& work, Real contact) {
    return is_wide(contact, work.edge_length)
               ? static_cast<Real>(default_contact) * work.edge_length
               : contact;
}

/// The next half-edge along the outline of the phase on the left.
template <class Real>
[[nodiscard]] Corner along_outline(const Complex<Real>& complex, Corner c) {
    const Phase phase = complex.phase_at(c);
    return next_along(complex, c, [&](Corner other) {
        return complex.phase_at(other) == phase && is_outline(complex, other);
    });
}

/// The vector from the start of the half-edge to its end.
template <class Real>
[[nodiscard, gnu::always_inline]] inline Point<Real> direction(const Complex<Real>& complex,
                                                               Corner c) {
    const VertexRecord<Real>& from = complex.vertices[complex.vertex(next(c))];
    const VertexRecord<Real>& to = complex.vertices[complex.vertex(prev(c))];
    return {to.x - from.x, to.y - from.y};
}

/// Twice the area of a triangle.
template <class Real>
[[nodiscard]] Real doubled_area(const Complex<Real>& complex, Triangle t) {
    const auto& v = complex.triangles[t.id].v;
    const auto& a = complex.vertices[v[0]];
    const auto& b = complex.vertices[v[1]];
    const auto& c = complex.vertices[v[2]];
    return (c.x - b.x) * (a.y - c.y) - (c.y - b.y) * (a.x - c.x);
}

/// Whether the application allows a film to open.
template <class Real>
[[nodiscard]] bool may_open(const TopologyWork<Real>& work, const Contact& contact) {
    return !work.options.may_change || work.options.may_change(contact);
}

/// Whether the vertex is blocked, or was before the change; false for dead and locked vertices.
template <class Real>
[[nodiscard]] bool is_blocked(const TopologyWork<Real>& work, std::uint32_t v) {
    const std::uint32_t flags = work.complex.is_alive(Vertex{v}) ? work.complex.vertices[v].flags
                                                                 : std::uint32_t{vertex_locked};
    return (flags & vertex_locked) == 0 &&
           ((flags & vertex_contact) != 0 || std::ranges::binary_search(work.blocked, v));
}

/// Whether two sheets of the interface met at the vertex.
template <class Real>
[[nodiscard]] bool is_on_seam(const TopologyWork<Real>& work, std::uint32_t v) {
    return (work.notes[Vertex{v}].what & noted_seam) != 0;
}

/// The position of a candidate before the sub-step.
template <class Real>
[[nodiscard]] Point<Real> place_before(const TopologyWork<Real>& work, std::uint32_t v) {
    const NotedPlace<Real>& place = work.places[Vertex{v}];
    return {place.x, place.y};
}
/// Whether a vertex has not moved in the sub-step, or is new.
template <class Real>
[[nodiscard]] bool rests(const TopologyWork<Real>& work, std::uint32_t v) {
    return work.notes[Vertex{v}].round != work.round ||
           place_before(work, v) == work.complex.position(Vertex{v});
}

/// The smallest height of a triangle.
template <class Real>
[[nodiscard]] Real thickness(const Complex<Real>& complex, Triangle t) {
    Real longest = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        longest = std::max(longest, direction(complex, corner_of(t.id, i)).squaredNorm());
    }
    return doubled_area(complex, t) / std::sqrt(longest);
}

/// The centre of gravity of a triangle. O(1).
template <class Real>
[[nodiscard]] Point<Real> centroid(const Complex<Real>& complex, Triangle t) {
    const auto v = complex.vertices_of(t);
    return (complex.position(v[0]) + complex.position(v[1]) + complex.position(v[2])) / Real(3);
}

/// Below this area a piece of a phase vanishes.
template <class Real>
[[nodiscard]] Real min_area(const TopologyWork<Real>& work) {
    return min_area(work.options, work.edge_length);
}

/// Small pieces have at most this many triangles per squared edge length, unless their edges are
/// very short.
inline constexpr std::size_t max_share_of_piece = 96;

/// The question to the application whether phases may take a triangle of a film. O(1).
template <class Real>
[[nodiscard]] Contact question_at(const Complex<Real>& complex, Triangle t,
                                  const std::array<Phase, 2>& sides) {
    const Point<double> place = centroid(complex, t).template cast<double>();
    return {.film = complex.phase(t),
            .sides = sides,
            .x = place.x(),
            .y = place.y(),
            .thickness = static_cast<double>(thickness(complex, t))};
}

/// The event that answers it, without its area.
template <class Real>
[[nodiscard]] Event event_at(const TopologyWork<Real>& work, EventKind kind, const Contact& at,
                             const std::array<Phase, 2>& taken) {
    return {.kind = kind, .time = work.time, .x = at.x, .y = at.y, .lost = at.film, .taken = taken};
}

/// Gives the triangle to another phase; its vertices may move again.
template <class Real>
void give(TopologyWork<Real>& work, Triangle t, Phase phase) {
    Complex<Real>& complex = work.complex;
    if (work.options.gives_back_area) {
        work.transfers.push_back({complex.phase(t), phase,
                                  static_cast<double>(doubled_area(complex, t)) / 2,
                                  centroid(complex, t).template cast<double>(), t});
    }
    rewire::relabel(complex, complex.journal, t, phase);
    for (const Vertex v : complex.vertices_of(t)) {
        std::uint32_t& flags = complex.vertices[v.id].flags;
        flags &= ~static_cast<std::uint32_t>(vertex_contact | vertex_feature);
        touch(work, v);
    }
}

/// Forgets the area that curves swept in landing on a side, and the transfers from this one on: the
/// flow itself would have moved the vertex there.
template <class Real>
void forget_landing(TopologyWork<Real>& work, std::size_t transfers) {
    work.transfers.erase(work.transfers.begin() + static_cast<std::ptrdiff_t>(transfers),
                         work.transfers.end());
    work.swept = 0;
}

} // namespace dsc
