// SPDX-License-Identifier: MIT
#include "dsc/parallel/ranks/edit_message.h"

#include "dsc/complex/rewire.h"
#include "dsc/operations/local_retriangulation.h"

#include <string>

namespace dsc {

namespace {

// The byte before each edit: its kind, and above it the reason of a move.
constexpr unsigned kind_bits = 4;
static_assert(edit_kind_count <= 1 << kind_bits);

[[noreturn]] void refuse(const std::string& problem) {
    throw InvariantError("the edits of another rank do not fit: " + problem);
}

template <class Real>
class Repeat {
public:
    Repeat(MessageReader& message, Complex<Real>& complex, EditLog& log)
        : message_(message), complex_(complex), log_(log) {}

    void one() {
        const auto first = message_.one<std::uint8_t>();
        const auto kind = static_cast<EditKind>(first & ((1U << kind_bits) - 1));
        switch (kind) {
        case EditKind::move: move(static_cast<MoveReason>(first >> kind_bits)); break;
        case EditKind::flip: rewire::flip(complex_, log_, corner(inner)); break;
        case EditKind::split: split(); break;
        case EditKind::collapse: collapse(); break;
        case EditKind::relabel: relabel(); break;
        case EditKind::retriangulate: retriangulate(); break;
        case EditKind::remove_vertex: remove_vertex(); break;
        default: refuse("an edit of the kind " + std::to_string(first));
        }
    }

private:
    enum class Where : std::uint8_t { anywhere, inside };
    static constexpr Where inner = Where::inside;

    std::uint32_t vertex() {
        const auto id = message_.one<std::uint32_t>();
        if (id >= complex_.vertex_bound()) {
            refuse("vertex " + std::to_string(id) + " does not exist");
        }
        return id;
    }
    std::uint32_t new_triangle() {
        const auto id = message_.one<std::uint32_t>();
        if (id == border_triangle || id >= complex_.triangle_bound() ||
            complex_.is_alive(Triangle{id})) {
            refuse("triangle " + std::to_string(id) + " cannot be new");
        }
        return id;
    }
    Triangle triangle() {
        const Triangle t{message_.one<std::uint32_t>()};
        if (!complex_.is_alive(t)) {
            refuse("triangle " + std::to_string(t.id) + " does not live");
        }
        return t;
    }
    Corner corner(Where where) {
        const auto c = message_.one<std::uint32_t>();
        if (index_of(c) > 2 || !complex_.is_alive(Triangle{triangle_of(c)}) ||
            (where == Where::inside && is_border(complex_.twin(c)))) {
            refuse("corner " + std::to_string(c) + " does not exist");
        }
        return c;
    }

    void move(MoveReason reason) {
        const std::uint32_t v = vertex();
        const auto x = message_.one<Real>();
        const auto y = message_.one<Real>();
        rewire::move(complex_, log_, v, x, y, reason);
    }

    void split() {
        const Corner c = corner(Where::anywhere);
        const std::uint32_t m = vertex();
        if (complex_.is_alive(Vertex{m})) {
            refuse("vertex " + std::to_string(m) + " cannot be new");
        }
        const std::uint32_t t2 = new_triangle();
        const std::uint32_t u2 = is_border(complex_.twin(c)) ? no_id : new_triangle();
        const auto x = message_.one<Real>();
        const auto y = message_.one<Real>();
        complex_.vertices[m] = VertexRecord<Real>{0, 0, no_id, 0, 0, no_id};
        rewire::split<Real>(complex_, log_, c, m, {x, y}, t2, u2);
    }

    void collapse() {
        const Corner c = corner(Where::anywhere);
        const std::uint32_t gone = vertex();
        const bool is_next = complex_.vertex(next(c)) == gone;
        if (!is_next && complex_.vertex(prev(c)) != gone) {
            refuse("vertex " + std::to_string(gone) + " is not at its edge");
        }
        rewire::collapse(complex_, log_, c,
                         is_next ? rewire::Vanishing::next : rewire::Vanishing::prev, freed_);
    }

    void relabel() {
        const Triangle t = triangle();
        rewire::relabel(complex_, log_, t, message_.one<Phase>());
    }

    void retriangulate() {
        const Triangle t = triangle();
        const Submesh submesh{Region{}, &freed_, &log_};
        if (local_retriangulation(complex_, submesh, t).verdict != Verdict::legal) {
            refuse("triangle " + std::to_string(t.id) + " cannot be retriangulated");
        }
    }

    // Done with the retriangulation before it, or of a vertex without triangles.
    void remove_vertex() {
        if (const std::uint32_t v = vertex(); complex_.is_alive(Vertex{v})) {
            complex_.give_vertex(freed_, v);
        }
    }

    MessageReader& message_;
    Complex<Real>& complex_;
    EditLog& log_;
    IdPool freed_;
};

} // namespace

template <class Real>
void write_edits(MessageWriter& message, std::span<const Edit> edits) {
    message.count(edits.size());
    for (const Edit& edit : edits) {
        const auto first = [&edit](unsigned what = 0) {
            return static_cast<std::uint8_t>(static_cast<unsigned>(edit.kind) | what << kind_bits);
        };
        const auto x = static_cast<Real>(edit.x);
        const auto y = static_cast<Real>(edit.y);
        switch (edit.kind) {
        case EditKind::move:
            message.raw(first(static_cast<unsigned>(edit.reason)), edit.vertex.id, x, y);
            break;
        case EditKind::flip: message.raw(first(), edit.corner); break;
        case EditKind::split:
            if (edit.made[1] == no_id) {
                message.raw(first(), edit.corner, edit.vertex.id, edit.made[0], x, y);
            } else {
                message.raw(first(), edit.corner, edit.vertex.id, edit.made, x, y);
            }
            break;
        case EditKind::collapse: message.raw(first(), edit.corner, edit.vertex.id); break;
        case EditKind::relabel:
            message.raw(first(), triangle_of(edit.corner), static_cast<Phase>(edit.made[1]));
            break;
        case EditKind::retriangulate: message.raw(first(), triangle_of(edit.corner)); break;
        case EditKind::remove_vertex: message.raw(first(), edit.vertex.id); break;
        case EditKind::insert_vertex:
        case EditKind::insert_triangle:
        case EditKind::remove_triangle:
        case EditKind::renumber:
        case EditKind::rebuild:
            throw InvariantError("a pass of a submesh made an edit of the whole complex: " +
                                 std::string(to_string(edit.kind)));
        }
    }
}

template <class Real>
void repeat_edits(MessageReader& message, Complex<Real>& complex, EditLog& log) {
    Repeat<Real> repeat(message, complex, log);
    for (std::uint64_t left = message.count(); left > 0; --left) {
        repeat.one();
    }
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void write_edits<Real>(MessageWriter&, std::span<const Edit>);                        \
    template void repeat_edits(MessageReader&, Complex<Real>&, EditLog&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
