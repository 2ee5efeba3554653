// SPDX-License-Identifier: MIT
#include "topology/notes.h"

#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"

#include <array>

namespace dsc {

namespace {

const char* const notes_name = "dsc.topology";
const char* const places_name = "dsc.topology.places";

} // namespace

template <class Real>
bool has_notes(const Complex<Real>& complex) {
    return complex.attributes.contains(notes_name);
}

template <class Real>
VertexAttribute<Note>& notes_of(Complex<Real>& complex) {
    if (has_notes(complex)) {
        return complex.attributes.template get<Vertex, Note>(notes_name);
    }
    return complex.attributes.template add<Vertex>(
        notes_name, Note{}, [](const Note& one, const Note& other, double) {
            return Note{.what = one.what & other.what & noted_wall};
        });
}

template <class Real>
VertexAttribute<NotedPlace<Real>>& places_of(Complex<Real>& complex) {
    return complex.attributes.contains(places_name)
               ? complex.attributes.template get<Vertex, NotedPlace<Real>>(places_name)
               : complex.attributes.template add<Vertex>(places_name, NotedPlace<Real>{});
}

template <class Real>
void begin_notes(Complex<Real>& complex) {
    VertexAttribute<Note>& notes = notes_of(complex);
    for (const Vertex v : vertices(complex)) {
        notes[v] = {};
    }
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            if (is_border(complex.twin(c))) {
                notes[Vertex{complex.vertex(next(c))}].what = noted_wall;
                notes[Vertex{complex.vertex(prev(c))}].what = noted_wall;
            }
        }
    }
}

namespace {

// The star of one vertex, as the upkeep has left it.
template <class Real>
std::uint32_t look_at(const Complex<Real>& complex, const VertexAttribute<Note>& notes,
                      const Notability<Real>& what, std::uint32_t round, const Ring<Real>& ring) {
    const Spokes spokes = interface_spokes(ring);
    if (spokes.count == 0) {
        return 0;
    }
    // All of an owned star is listed here: nobody else writes to its notes. Of any other nothing is
    // known, except that it may face a sheet.
    const bool is_beside_wall = ring.owned && faces_wall(complex, ring);
    const bool may_face = !ring.owned || is_beside_wall || may_face_a_sheet(notes, round, ring);
    // Which of the stars that face no sheet are thin matters once something else has changed: they
    // are looked at then.
    const bool is_thin = !may_face || has_thin_triangle(ring, what.contact * what.contact);
    const bool is_sharp =
        spokes.count > 2 || (spokes.count == 2 && turns_sharply(Bend(ring, spokes)));
    const bool ends_on_wall = !ring.closed && (spokes.first != 0 || spokes.second != ring.size);
    const bool is_notable =
        is_sharp || (spokes.count == 2 && (turns_tightly(Bend(ring, spokes), what.curvature) ||
                                           ends_on_wall || (ring.closed && is_beside_wall)));
    const bool is_junction = is_sharp && (spokes.count != 2 || !ring.closed);
    return (is_thin ? noted_thin : 0U) | (is_thin && may_face ? noted_facing : 0U) |
           (is_notable ? noted_sharp : 0U) | (is_junction ? noted_junction : 0U);
}

// Nearly all stars have nothing to tell: two edges of the interface that hardly turn, no domain
// boundary, and no second sheet. That is seen without gathering them. False where anything is
// otherwise, or the star is not owned as a whole.
template <class Real>
bool is_plain(const Work<Real>& work, const VertexAttribute<Note>& notes, Real curvature,
              std::uint32_t round, std::uint32_t v) {
    const Complex<Real>& complex = work.complex;
    const Region& region = work.submesh.region;
    const Corner start = complex.vertices[v].corner;
    if (start == no_id || !owns(complex, region, v)) {
        return false;
    }
    std::array<std::uint32_t, 2> ends{}; // of the interface's edges
    std::uint32_t edges = 0;
    std::uint32_t w = no_id;
    Phase phase = 0;
    bool was_noted = false;
    bool is_round = false;
    // Enters each triangle through the edge opposite to `entrance`, counter-clockwise, and ends
    // with the first one once more.
    const Corner first = prev(start);
    Corner entrance = first;
    for (std::uint32_t i = 0; i <= Ring<Real>::capacity && !is_round; ++i) {
        const TriangleRecord& triangle = complex.triangles[triangle_of(entrance)];
        const std::uint32_t exit = prev_index(index_of(entrance));
        w = triangle.v[exit];
        if (is_border(triangle.n[next_index(index_of(entrance))]) || !owns(complex, region, w)) {
            return false;
        }
        const bool is_noted_now = is_noted(notes[Vertex{w}], round);
        if (i > 0) {
            if (is_noted_now && was_noted) {
                return false;
            }
            if (triangle.phase != phase) {
                if (edges == 2) {
                    return false;
                }
                ends[edges++] = w;
            }
            is_round = entrance == first;
        }
        was_noted = is_noted_now;
        phase = triangle.phase;
        entrance = triangle.n[exit];
        if (is_border(entrance)) {
            return false;
        }
    }
    if (!is_round || edges != 2) {
        return false;
    }
    const auto& from = complex.vertices[ends[0]];
    const auto& at = complex.vertices[v];
    const auto& to = complex.vertices[ends[1]];
    const Bend<Real> bend(from.x, from.y, at.x, at.y, to.x, to.y);
    return !turns_sharply(bend) && !turns_tightly(bend, curvature);
}

} // namespace

template <class Real>
void note_stars(Work<Real>& work, const Notability<Real>& what, std::uint32_t round) {
    if (what.contact == 0) {
        return;
    }
    Complex<Real>& complex = work.complex;
    VertexAttribute<Note>& notes = notes_of(complex);
    VertexAttribute<NotedPlace<Real>>& places = places_of(complex);
    for (const std::uint32_t v : work.interface) {
        const auto& record = complex.vertices[v];
        if ((record.flags & vertex_dead) == 0) {
            places[Vertex{v}] = {record.x, record.y};
            notes[Vertex{v}] = {round, notes[Vertex{v}].what & noted_for_ever};
        }
    }
    for (const std::uint32_t v : work.interface) {
        if (is_plain(work, notes, what.curvature, round, v)) {
            notes[Vertex{v}].what |= noted_thin; // as far as is known: see look_at
        } else if (complex.is_alive(Vertex{v}) &&
                   gather(complex, work.submesh.region, v, work.ring)) {
            notes[Vertex{v}].what |= look_at(complex, notes, what, round, work.ring);
        }
    }
}

template VertexAttribute<Note>& notes_of(Complex<double>&);
template VertexAttribute<Note>& notes_of(Complex<float>&);
template VertexAttribute<NotedPlace<double>>& places_of(Complex<double>&);
template VertexAttribute<NotedPlace<float>>& places_of(Complex<float>&);
template bool has_notes(const Complex<double>&);
template bool has_notes(const Complex<float>&);
template void begin_notes(Complex<double>&);
template void begin_notes(Complex<float>&);
template void note_stars(Work<double>&, const Notability<double>&, std::uint32_t);
template void note_stars(Work<float>&, const Notability<float>&, std::uint32_t);

} // namespace dsc
