// SPDX-License-Identifier: MIT
#include "topology/notes.h"

#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"
#include "dsc/motion/time_ahead.h"
#include "dsc/passes/work.h"

#include <algorithm>

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
            return Note{.round = std::min(one.round, other.round),
                        .what = one.what & other.what & noted_boundary};
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
    VertexAttribute<TimeAhead<Real>>& ahead = times_ahead_of(complex);
    for (const Vertex v : vertices(complex)) {
        notes[v] = {};
        ahead[v] = {};
    }
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t.id, i);
            if (is_border(complex.twin(c))) {
                notes[Vertex{complex.vertex(next(c))}].what = noted_boundary;
                notes[Vertex{complex.vertex(prev(c))}].what = noted_boundary;
            }
        }
    }
}

namespace {

// The star of one vertex, as the remeshing has left it.
template <class Real>
std::uint32_t look_at(const Complex<Real>& complex, const VertexAttribute<Note>& notes,
                      const Notability<Real>& what, std::uint32_t round, const Star<Real>& star,
                      const IncidentEdges& incident) {
    if (incident.count == 0) {
        return 0;
    }
    // The vertices of an owned star are all listed in this work, so no other thread writes their
    // notes. A star that is not owned is assumed to face a sheet. Vertices on the domain boundary
    // count as noted.
    const bool may_face = !star.owned || may_face_a_sheet(notes, round, star);
    const bool is_beside_boundary = star.owned && may_face && faces_boundary(complex, star);
    // Thinness of a star that faces no sheet matters only after something else has changed, and is
    // tested then.
    const bool is_thin = !may_face || has_thin_triangle(star, what.contact * what.contact);
    const bool is_sharp =
        incident.count > 2 || (incident.count == 2 && turns_sharply(Bend(star, incident)));
    const bool ends_on_boundary =
        !star.closed && (incident.first != 0 || incident.second != star.size);
    const bool is_notable = is_sharp || (incident.count == 2 &&
                                         (turns_tightly(Bend(star, incident), what.curvature) ||
                                          ends_on_boundary || (star.closed && is_beside_boundary)));
    const bool is_junction = is_sharp && (incident.count != 2 || !star.closed);
    return (is_thin ? noted_thin : 0U) | (is_thin && may_face ? noted_facing : 0U) |
           (is_notable ? noted_sharp : 0U) | (is_junction ? noted_junction : 0U);
}

// Notes that the vertex is on the interface, and its position.
template <class Real>
Note& note_vertex(const Complex<Real>& complex, std::uint32_t v, std::uint32_t round,
                  const Notebook<Real>& book) {
    Note& note = (*book.notes)[Vertex{v}];
    const bool is_first =
        note.round == round ? (note.what & noted_first) != 0 : round - note.round > 1;
    note = {round, (note.what & noted_for_ever) | (is_first ? noted_first : 0U)};
    (*book.places)[Vertex{v}] = {complex.vertices[v].x, complex.vertices[v].y};
    return note;
}

} // namespace

template <class Real>
void note_star(const Work<Real>& work, const Star<Real>& star, const IncidentEdges& incident,
               const Notability<Real>& what, std::uint32_t round, const Notebook<Real>& book) {
    const std::uint32_t seen = look_at(work.complex, *book.notes, what, round, star, incident);
    note_vertex(work.complex, star.vertex, round, book).what |= seen | noted_star;
}

template <class Real>
void note_stars(Work<Real>& work, const Notability<Real>& what, std::uint32_t round) {
    if (what.contact == 0) {
        return;
    }
    Complex<Real>& complex = work.complex;
    const Notebook<Real> book{&notes_of(complex), &places_of(complex)};
    VertexAttribute<Note>& notes = *book.notes;
    // All vertices are noted before any star, because stars are examined by the notes of
    // neighbours.
    std::vector<std::uint32_t>& left = work.interface_next; // scratch of the remeshing
    left.clear();
    bool has_first = false;
    for (const std::uint32_t v : work.interface) {
        if (!complex.is_alive(Vertex{v})) {
            continue;
        }
        const bool is_noted = notes[Vertex{v}].round == round &&
                              (notes[Vertex{v}].what & noted_star) != 0 &&
                              complex.vertices[v].stamp != work.epoch;
        if (!is_noted) {
            note_vertex(complex, v, round, book);
            left.push_back(v);
        }
        has_first = has_first || (notes[Vertex{v}].what & noted_first) != 0;
    }
    // A star noted earlier may face a vertex that had no note at that time, so it is examined
    // again.
    for (const std::uint32_t v : has_first ? work.interface : left) {
        if (complex.is_alive(Vertex{v}) && gather(complex, work.submesh.region, v, work.star)) {
            note_star(work, work.star, interface_edges_of(work.star), what, round, book);
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
template void note_star(const Work<double>&, const Star<double>&, const IncidentEdges&,
                        const Notability<double>&, std::uint32_t, const Notebook<double>&);
template void note_star(const Work<float>&, const Star<float>&, const IncidentEdges&,
                        const Notability<float>&, std::uint32_t, const Notebook<float>&);
template void note_stars(Work<double>&, const Notability<double>&, std::uint32_t);
template void note_stars(Work<float>&, const Notability<float>&, std::uint32_t);

} // namespace dsc
