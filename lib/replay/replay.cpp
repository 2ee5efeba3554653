// SPDX-License-Identifier: MIT
#include "replay/edits.h"

#include "dsc/base/error.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/rewire.h"

#include <string>
#include <utility>

namespace dsc {

namespace {

template <class Real>
class Replay {
public:
    Replay(Complex<Real>& complex, std::size_t edits, const RepeatEdit<Real>& others)
        : complex_(complex), others_(others),
          max_vertices_(room_for(complex.vertex_bound(), edits)),
          max_triangles_(room_for(complex.triangle_bound(), edits)),
          readers_(std::exchange(complex.journal.readers, 0U)) {}

    bool play(const Edit& edit) {
        switch (edit.kind) {
        case EditKind::flip: return flip(edit);
        case EditKind::split: return split(edit);
        case EditKind::collapse: return collapse(edit);
        case EditKind::move: return move(edit);
        case EditKind::relabel: return relabel(edit);
        case EditKind::insert_vertex: return insert_vertex(edit);
        case EditKind::remove_vertex: return remove_vertex(edit);
        case EditKind::renumber:
            gather_free_ids();
            renumber(complex_);
            return true;
        case EditKind::retriangulate:
        case EditKind::insert_triangle:
        case EditKind::remove_triangle: return other(edit);
        case EditKind::rebuild: break; // refused before anything is done
        }
        return false;
    }

    // The journal has recorded nothing. A `rebuild` makes its readers examine the whole complex
    // again.
    void end() {
        complex_.journal.readers = readers_;
        rewire::note(complex_.journal, [] { return Edit{.kind = EditKind::rebuild}; });
        gather_free_ids();
    }

private:
    // Collects every id that is not alive in the pool of the complex.
    void gather_free_ids() {
        complex_.ids.clear();
        for (std::uint32_t v = complex_.vertex_bound(); v-- > 0;) {
            if (!complex_.is_alive(Vertex{v})) {
                complex_.ids.vertices.push_back(v);
            }
        }
        for (std::uint32_t t = complex_.triangle_bound(); t-- > 1;) {
            if (!complex_.is_alive(Triangle{t})) {
                complex_.ids.triangles.push_back(t);
            }
        }
    }

    // Whether the edge opposite to the corner is the edge of the record.
    [[nodiscard]] bool is_edge(const Edit& edit) const {
        const Corner c = edit.corner;
        if (index_of(c) > 2 || !complex_.is_alive(Triangle{triangle_of(c)})) {
            return false;
        }
        const Corner across = complex_.twin(c);
        const std::array<std::uint32_t, 2> ends{complex_.vertex(next(c)), complex_.vertex(prev(c))};
        const bool same = ends[0] == edit.ends[0].id && ends[1] == edit.ends[1].id;
        const bool turned = ends[1] == edit.ends[0].id && ends[0] == edit.ends[1].id;
        return (same || turned) && complex_.vertex(c) == edit.apexes[0].id &&
               (is_border(across) ? !edit.apexes[1].is_valid()
                                  : complex_.vertex(across) == edit.apexes[1].id);
    }

    // An upper bound on the ids of a run with this many edits: its submeshes hold some for each
    // vertex of the interface, and a few more. A record with a higher id is not from this run, and
    // must not fill the memory.
    static std::uint64_t room_for(std::uint32_t bound, std::size_t edits) {
        return (std::uint64_t{1} << 20U) + 64 * (std::uint64_t{bound} + edits);
    }
    // Makes room for an id that came from the pool of a submesh. False if there is no such id.
    bool have_vertex(std::uint32_t id) {
        if (id >= max_vertices_) {
            return false;
        }
        while (complex_.vertex_bound() <= id) {
            const std::uint32_t added = complex_.take_vertex(fresh_);
            complex_.vertices[added].flags = vertex_dead;
        }
        return true;
    }
    bool have_triangle(std::uint32_t id) {
        if (id == border_triangle || id >= max_triangles_) {
            return false;
        }
        while (complex_.triangle_bound() <= id) {
            const std::uint32_t added = complex_.take_triangle(fresh_);
            complex_.triangles[added].v = {no_id, no_id, no_id};
        }
        return true;
    }

    bool flip(const Edit& edit) {
        if (!is_edge(edit) || is_border(complex_.twin(edit.corner))) {
            return false;
        }
        rewire::flip(complex_, silent_, edit.corner);
        return true;
    }

    bool split(const Edit& edit) {
        if (!is_edge(edit)) {
            return false;
        }
        const bool border = is_border(complex_.twin(edit.corner));
        if (!have_vertex(edit.vertex.id) || !have_triangle(edit.made[0]) ||
            (!border && (edit.made[0] == edit.made[1] || !have_triangle(edit.made[1])))) {
            return false;
        }
        if (complex_.is_alive(edit.vertex) || complex_.is_alive(Triangle{edit.made[0]}) ||
            (!border && complex_.is_alive(Triangle{edit.made[1]}))) {
            return false;
        }
        complex_.vertices[edit.vertex.id] = VertexRecord<Real>{0, 0, no_id, 0, 0, no_id};
        rewire::split(complex_, silent_, edit.corner, edit.vertex.id, place(edit), edit.made[0],
                      border ? no_id : edit.made[1]);
        return true;
    }

    bool collapse(const Edit& edit) {
        if (!is_edge(edit)) {
            return false;
        }
        const bool is_next = complex_.vertex(next(edit.corner)) == edit.vertex.id;
        if (!is_next && complex_.vertex(prev(edit.corner)) != edit.vertex.id) {
            return false;
        }
        rewire::collapse(complex_, silent_, edit.corner,
                         is_next ? rewire::Vanishing::next : rewire::Vanishing::prev, freed_);
        return true;
    }

    bool move(const Edit& edit) {
        if (!complex_.is_alive(edit.vertex)) {
            return false;
        }
        const Point<Real> to = place(edit);
        rewire::move(complex_, silent_, edit.vertex.id, to.x(), to.y(), edit.reason);
        return true;
    }

    bool relabel(const Edit& edit) {
        const Triangle t{triangle_of(edit.corner)};
        if (!complex_.is_alive(t) || complex_.phase(t) != edit.made[0]) {
            return false;
        }
        rewire::relabel(complex_, silent_, t, edit.made[1]);
        return true;
    }

    bool insert_vertex(const Edit& edit) {
        if (!have_vertex(edit.vertex.id) || complex_.is_alive(edit.vertex)) {
            return false;
        }
        const Point<Real> at = place(edit);
        complex_.vertices[edit.vertex.id] = VertexRecord<Real>{at.x(), at.y(), no_id, 0, 0, no_id};
        complex_.attributes.reset_vertex(edit.vertex.id);
        return true;
    }

    bool remove_vertex(const Edit& edit) {
        if (!complex_.is_alive(edit.vertex)) {
            return true; // repeated together with the preceding retriangulation
        }
        if (complex_.vertices[edit.vertex.id].corner != no_id) {
            return false;
        }
        complex_.give_vertex(freed_, edit.vertex.id);
        return true;
    }

    // An operation of a module.
    bool other(const Edit& edit) {
        if (edit.kind == EditKind::insert_triangle) {
            const std::uint32_t id = triangle_of(edit.corner);
            if (!have_triangle(id) || complex_.is_alive(Triangle{id})) {
                return false;
            }
            complex_.ids.triangles.assign(1, id);
        }
        return others_({complex_, Region{}, freed_, silent_}, edit);
    }

    static Point<Real> place(const Edit& edit) {
        return {static_cast<Real>(edit.x), static_cast<Real>(edit.y)};
    }

    Complex<Real>& complex_;
    const RepeatEdit<Real>& others_;
    std::uint64_t max_vertices_;
    std::uint64_t max_triangles_;
    std::uint32_t readers_;
    EditLog silent_;
    IdPool fresh_; // always empty, so that ids taken from it are new
    IdPool freed_; // not used: the records say which id comes next
};

// Refuses records that cannot be repeated from the log alone.
void check_kinds(std::span<const Edit> edits, bool has_others) {
    for (const Edit& edit : edits) {
        const bool of_a_module = edit.kind == EditKind::retriangulate ||
                                 edit.kind == EditKind::insert_triangle ||
                                 edit.kind == EditKind::remove_triangle;
        if (edit.kind == EditKind::rebuild || (of_a_module && !has_others)) {
            throw InputError({.what = "this record cannot be repeated from the log alone",
                              .where = "replay",
                              .value = std::string(to_string(edit.kind)),
                              .allowed = of_a_module ? "this kind with a function that repeats it"
                                                     : "records of any other kind"});
        }
    }
}

} // namespace

template <class Real>
ReplayReport replay(Complex<Real>& complex, std::span<const Edit> edits,
                    const RepeatEdit<Real>& others) {
    check_kinds(edits, static_cast<bool>(others));
    Replay<Real> again(complex, edits.size(), others);
    ReplayReport report;
    try {
        for (const Edit& edit : edits) {
            ++(again.play(edit) ? report.done : report.skipped);
        }
    } catch (...) { // no memory, or an attribute of the application
        again.end();
        throw;
    }
    again.end();
    complex.attributes.failure.rethrow();
    return report;
}

template ReplayReport replay(Complex<double>&, std::span<const Edit>, const RepeatEdit<double>&);
template ReplayReport replay(Complex<float>&, std::span<const Edit>, const RepeatEdit<float>&);

} // namespace dsc
