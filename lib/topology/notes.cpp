// SPDX-License-Identifier: MIT
#include "topology/notes.h"

#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"

namespace dsc {

namespace {

const char* const notes_name = "dsc.topology";

} // namespace

template <class Real>
bool has_notes(const Complex<Real>& complex) {
    return complex.attributes.contains(notes_name);
}

template <class Real>
VertexAttribute<Note<Real>>& notes_of(Complex<Real>& complex) {
    if (has_notes(complex)) {
        return complex.attributes.template get<Vertex, Note<Real>>(notes_name);
    }
    return complex.attributes.template add<Vertex>(
        notes_name, Note<Real>{}, [](const Note<Real>& one, const Note<Real>& other, double) {
            return Note<Real>{.what = one.what & other.what & noted_wall};
        });
}

template <class Real>
void begin_notes(Complex<Real>& complex) {
    VertexAttribute<Note<Real>>& notes = notes_of(complex);
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
std::uint32_t look_at(const Complex<Real>& complex, const VertexAttribute<Note<Real>>& notes,
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
    const bool is_sharp = spokes.count > 2 || (spokes.count == 2 && turns_sharply(ring, spokes));
    const bool ends_on_wall = !ring.closed && (spokes.first != 0 || spokes.second != ring.size);
    const bool is_notable =
        is_sharp || (spokes.count == 2 && (turns_tightly(ring, spokes, what.curvature) ||
                                           ends_on_wall || (ring.closed && is_beside_wall)));
    const bool is_junction = is_sharp && (spokes.count != 2 || !ring.closed);
    return (is_thin ? noted_thin : 0U) | (is_thin && may_face ? noted_facing : 0U) |
           (is_notable ? noted_sharp : 0U) | (is_junction ? noted_junction : 0U);
}

} // namespace

template <class Real>
void note_stars(Work<Real>& work, const Notability<Real>& what, std::uint32_t round) {
    if (what.contact == 0) {
        return;
    }
    Complex<Real>& complex = work.complex;
    VertexAttribute<Note<Real>>& notes = notes_of(complex);
    for (const std::uint32_t v : work.interface) {
        const auto& record = complex.vertices[v];
        if ((record.flags & vertex_dead) == 0) {
            notes[Vertex{v}] = {record.x, record.y, round, notes[Vertex{v}].what & noted_for_ever};
        }
    }
    for (const std::uint32_t v : work.interface) {
        if (complex.is_alive(Vertex{v}) && gather(complex, work.submesh.region, v, work.ring)) {
            notes[Vertex{v}].what |= look_at(complex, notes, what, round, work.ring);
        }
    }
}

template VertexAttribute<Note<double>>& notes_of(Complex<double>&);
template VertexAttribute<Note<float>>& notes_of(Complex<float>&);
template bool has_notes(const Complex<double>&);
template bool has_notes(const Complex<float>&);
template void begin_notes(Complex<double>&);
template void begin_notes(Complex<float>&);
template void note_stars(Work<double>&, const Notability<double>&, std::uint32_t);
template void note_stars(Work<float>&, const Notability<float>&, std::uint32_t);

} // namespace dsc
