// SPDX-License-Identifier: MIT
// The living simplices of a complex as ranges of handles:
//
//     for (const Triangle t : triangles(complex, 1)) {
//         for (const Vertex v : complex.vertices_of(t)) ...
//
// All are forward ranges and views, so they work with std::ranges. They allocate
// nothing and cost as much as a loop over the ids. Iterators hold a pointer to the complex, which
// must outlive them.
//
// Positions and phases may change during a loop. In loops over vertices, edges and triangles,
// operations may also change connectivity: each simplex is alive when it is reached, and ids that
// did not exist when the loop began are not visited. In loops over the star or the link of a
// vertex, that star must not change.
#pragma once

#include "dsc/complex/circulate.h"

#include <iterator>
#include <limits>
#include <ranges>

namespace dsc {

namespace detail {

/// A forward iterator from a cursor: a small value with handle(), advance() and ==.
template <class Cursor>
class HandleIterator {
public:
    using iterator_concept = std::forward_iterator_tag;
    using iterator_category = std::input_iterator_tag; // dereferencing gives a value
    using value_type = decltype(Cursor().handle());
    using difference_type = std::ptrdiff_t;
    using reference = value_type;
    using pointer = void;

    HandleIterator() = default;
    explicit HandleIterator(const Cursor& cursor) : cursor_(cursor) {}

    [[nodiscard]] value_type operator*() const { return cursor_.handle(); }
    HandleIterator& operator++() {
        cursor_.advance();
        return *this;
    }
    HandleIterator operator++(int) {
        const HandleIterator before = *this;
        cursor_.advance();
        return before;
    }
    friend bool operator==(const HandleIterator&, const HandleIterator&) = default;

private:
    Cursor cursor_;
};

} // namespace detail

/// A range of handles that a cursor walks through.
template <class Cursor>
class HandleRange : public std::ranges::view_base {
public:
    using iterator = detail::HandleIterator<Cursor>; ///< forward; its values are handles

    HandleRange() = default;
    /// From one cursor to another, the second excluded.
    HandleRange(const Cursor& first, const Cursor& last)
        : first_(iterator(first)), last_(iterator(last)) {}

    /// The first handle.
    [[nodiscard]] iterator begin() const { return first_; }
    /// Behind the last handle.
    [[nodiscard]] iterator end() const { return last_; }
    /// Whether there is none.
    [[nodiscard]] bool empty() const { return first_ == last_; }

private:
    iterator first_;
    iterator last_;
};

namespace detail {

/// Whether a simplex lives.
template <class Real>
struct IsAlive {
    const Complex<Real>* complex = nullptr;

    bool operator()(auto handle) const { return complex->is_alive(handle); }
};

/// Whether a triangle lives and has this phase.
template <class Real>
struct IsOfPhase {
    const Complex<Real>* complex = nullptr;
    Phase phase = exterior_phase;

    bool operator()(Triangle t) const { return complex->is_alive(t) && complex->phase(t) == phase; }
};

/// The handles that pass a test, by ascending id from `id` up to `bound`, which is fixed at the
/// start.
template <class Handle, class Test>
struct IdCursor {
    Test test;
    std::uint32_t id = 0;
    std::uint32_t bound = 0;

    [[nodiscard]] Handle handle() const { return Handle{id}; }
    void advance() {
        ++id;
        skip_failing();
    }
    /// Advances to the first id that passes; stays if the current one does.
    void skip_failing() {
        while (id < bound && !test(Handle{id})) {
            ++id;
        }
    }
    friend bool operator==(const IdCursor& a, const IdCursor& b) { return a.id == b.id; }
};

template <class Handle, class Test>
HandleRange<IdCursor<Handle, Test>> handles(const Test& test, std::uint32_t from,
                                            std::uint32_t bound) {
    IdCursor<Handle, Test> first{test, from, bound};
    first.skip_failing();
    return {first, {test, bound, bound}};
}

/// The corners at a vertex, counter-clockwise; no_id behind the last.
template <class Real>
struct CornerCursor {
    const Complex<Real>* complex = nullptr;
    Corner first = no_id;
    Corner corner = no_id;

    void advance() {
        corner = corner_ccw(*complex, corner);
        if (is_border(corner) || corner == first) {
            corner = no_id;
        }
    }
    friend bool operator==(const CornerCursor& a, const CornerCursor& b) {
        return a.corner == b.corner;
    }
};

template <class Real>
struct StarCursor : CornerCursor<Real> {
    [[nodiscard]] Triangle handle() const { return Triangle{triangle_of(this->corner)}; }
};

/// The next vertex in each triangle; after the last triangle of an open star, also its last link
/// vertex.
template <class Real>
struct LinkCursor : CornerCursor<Real> {
    bool is_behind = false;

    [[nodiscard]] Vertex handle() const {
        return Vertex{this->complex->vertex(is_behind ? prev(this->corner) : next(this->corner))};
    }
    void advance() {
        const Corner following = is_behind ? no_id : corner_ccw(*this->complex, this->corner);
        is_behind = is_border(following);
        if (!is_behind) {
            this->corner = following == this->first ? no_id : following;
        }
    }
    friend bool operator==(const LinkCursor&, const LinkCursor&) = default;
};

template <class Real>
CornerCursor<Real> corners_at(const Complex<Real>& complex, Vertex v) {
    const Corner start = complex.vertices[v.id].corner;
    const Corner first = start == no_id ? no_id : first_corner(complex, start);
    return {&complex, first, first};
}

} // namespace detail

/// The living vertices by ascending id, those without triangles included. Begins in O(1), apart
/// from free ids in front; O(ids) as a whole.
template <class Real>
[[nodiscard]] auto vertices(const Complex<Real>& complex) {
    return detail::handles<Vertex>(detail::IsAlive<Real>{&complex}, 0, complex.vertex_bound());
}

/// The ids of a range of handles, in its order. O(ids).
template <class Cursor>
[[nodiscard]] std::vector<std::uint32_t> ids_of(const HandleRange<Cursor>& range) {
    std::vector<std::uint32_t> ids;
    for (const auto handle : range) {
        ids.push_back(handle.id);
    }
    return ids;
}

/// The lowest and the highest corner of the bounding box of the living vertices; from infinity to
/// minus infinity if there are none. O(ids).
template <class Real>
[[nodiscard]] std::array<Point<Real>, 2> bounds_of(const Complex<Real>& complex) {
    Point<Real> low = Point<Real>::Constant(std::numeric_limits<Real>::infinity());
    Point<Real> high = -low;
    for (const Vertex v : vertices(complex)) {
        low = low.cwiseMin(complex.position(v));
        high = high.cwiseMax(complex.position(v));
    }
    return {low, high};
}

/// The living triangles by ascending id. O(ids) as a whole.
template <class Real>
[[nodiscard]] auto triangles(const Complex<Real>& complex) {
    return detail::handles<Triangle>(detail::IsAlive<Real>{&complex}, border_triangle + 1,
                                     complex.triangle_bound());
}

/// The living triangles of a phase by ascending id. O(ids) as a whole.
template <class Real>
[[nodiscard]] auto triangles(const Complex<Real>& complex, Phase phase) {
    return detail::handles<Triangle>(detail::IsOfPhase<Real>{&complex, phase}, border_triangle + 1,
                                     complex.triangle_bound());
}

/// The living edges by ascending id, the inner ones and those of the domain boundary. O(ids) as a
/// whole.
template <class Real>
[[nodiscard]] auto edges(const Complex<Real>& complex) {
    return detail::handles<Edge>(detail::IsAlive<Real>{&complex}, corner_of(border_triangle + 1, 0),
                                 corner_of(complex.triangle_bound(), 0));
}

/// The triangles of the star of a living vertex, counter-clockwise; on the domain boundary from the
/// clockwise end on. Empty where the vertex has no triangle. O(degree) as a whole.
template <class Real>
[[nodiscard]] auto star_triangles(const Complex<Real>& complex, Vertex v) {
    using Cursor = detail::StarCursor<Real>;
    return HandleRange<Cursor>(Cursor{detail::corners_at(complex, v)}, Cursor{});
}

/// The vertices of the link of a living vertex, that is, its neighbours, in the order of
/// `star_triangles`; on the domain boundary there is one more than triangles. O(degree) as a whole.
template <class Real>
[[nodiscard]] auto link_vertices(const Complex<Real>& complex, Vertex v) {
    using Cursor = detail::LinkCursor<Real>;
    return HandleRange<Cursor>(Cursor{detail::corners_at(complex, v)}, Cursor{});
}

} // namespace dsc

template <class Cursor>
inline constexpr bool std::ranges::enable_borrowed_range<dsc::HandleRange<Cursor>> = true;
