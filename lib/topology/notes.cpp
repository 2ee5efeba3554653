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
                        .what = (one.what | other.what) & noted_change};
        });
}

template <class Real>
VertexAttribute<NotedPlace<Real>>& places_of(Complex<Real>& complex) {
    return complex.attributes.contains(places_name)
               ? complex.attributes.template get<Vertex, NotedPlace<Real>>(places_name)
               : complex.attributes.template add<Vertex>(
                     places_name, NotedPlace<Real>{},
                     [](const NotedPlace<Real>& one, const NotedPlace<Real>& other, double share) {
                         const auto s = static_cast<Real>(share);
                         return NotedPlace<Real>{one.x + s * (other.x - one.x),
                                                 one.y + s * (other.y - one.y)};
                     });
}

template <class Real>
void begin_notes(Complex<Real>& complex) {
    VertexAttribute<Note>& notes = notes_of(complex);
    VertexAttribute<TimeAhead<Real>>& ahead = times_ahead_of(complex);
    for (const Vertex v : vertices(complex)) {
        notes[v] = {};
        ahead[v] = {};
    }
}

namespace {

// The star of one vertex, as the remeshing has left it.
template <class Real>
std::uint32_t look_at(Real curvature, const Star<Real>& star, const IncidentEdges& incident) {
    if (incident.count == 0) {
        return 0;
    }
    const bool is_sharp =
        incident.count > 2 || (incident.count == 2 && turns_sharply(Bend(star, incident)));
    const bool ends_on_boundary =
        !star.closed && (incident.first != 0 || incident.second != star.size);
    const bool is_notable =
        is_sharp || (incident.count == 2 &&
                     (turns_tightly(Bend(star, incident), curvature) || ends_on_boundary));
    const bool is_junction =
        (is_sharp && (incident.count != 2 || !star.closed)) || ends_on_boundary;
    return (is_notable ? noted_sharp : 0U) | (is_junction ? noted_junction : 0U);
}

// Notes that the vertex is on the interface, and its position.
template <class Real>
Note& note_vertex(const Complex<Real>& complex, std::uint32_t v, std::uint32_t round,
                  const Notebook<Real>& book) {
    Note& note = (*book.notes)[Vertex{v}];
    note = {round, note.what & noted_seam};
    (*book.places)[Vertex{v}] = {complex.vertices[v].x, complex.vertices[v].y};
    return note;
}

} // namespace

template <class Real>
void note_star(const Work<Real>& work, const Star<Real>& star, const IncidentEdges& incident,
               Real curvature, std::uint32_t round, const Notebook<Real>& book) {
    note_vertex(work.complex, star.vertex, round, book).what |=
        look_at(curvature, star, incident) | noted_star;
}

template <class Real>
void note_stars(Work<Real>& work, Real curvature, std::uint32_t round) {
    if (curvature == 0) {
        return;
    }
    Complex<Real>& complex = work.complex;
    const Notebook<Real> book{&notes_of(complex), &places_of(complex)};
    for (const std::uint32_t v : work.interface) {
        if (!complex.is_alive(Vertex{v})) {
            continue;
        }
        const Note note = (*book.notes)[Vertex{v}];
        if (note.round == round && (note.what & noted_star) != 0 &&
            complex.vertices[v].stamp != work.epoch) {
            continue;
        }
        note_vertex(complex, v, round, book);
        if (gather(complex, work.submesh.region, v, work.star)) {
            note_star(work, work.star, interface_edges_of(work.star), curvature, round, book);
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
template void note_star(const Work<double>&, const Star<double>&, const IncidentEdges&, double,
                        std::uint32_t, const Notebook<double>&);
template void note_star(const Work<float>&, const Star<float>&, const IncidentEdges&, float,
                        std::uint32_t, const Notebook<float>&);
template void note_stars(Work<double>&, double, std::uint32_t);
template void note_stars(Work<float>&, float, std::uint32_t);

} // namespace dsc
