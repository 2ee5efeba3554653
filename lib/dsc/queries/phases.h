// SPDX-License-Identifier: MIT
// Phases, and quantities derived from them (thesis, section 8.6): the interface, the domain
// boundary, the connected components, and the curves where phases meet. `interface_curves` cuts the
// whole interface at its junctions; `outlines` gives the closed loops around one phase, or around
// several taken together. Handles must be alive. Thread-safe while nobody writes.
#pragma once

#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace dsc {

/// Whether `test(corner)` holds for one of the edges at `v`, each named by a corner opposite to it.
/// O(degree).
template <class Real, class Test>
[[nodiscard]] bool any_edge(const Complex<Real>& complex, Vertex v, Test test) {
    return find_corner(complex, v, [&](Corner c) {
               return test(prev(c)) || (is_border(complex.twin(next(c))) && test(next(c)));
           }) != no_id;
}
/// The same of a triangle. O(1).
template <class Real, class Test>
[[nodiscard]] bool any_edge(const Complex<Real>& /*complex*/, Triangle t, Test test) {
    return test(corner_of(t.id, 0)) || test(corner_of(t.id, 1)) || test(corner_of(t.id, 2));
}
/// The same for a single edge. O(1).
template <class Real, class Test>
[[nodiscard]] bool any_edge(const Complex<Real>& /*complex*/, Edge e, Test test) {
    return test(e.id);
}

/// An edge is on the domain boundary if it has one triangle, a vertex if it has such an edge. The
/// form for a triangle asks whether one of its edges is. O(1); O(degree) for a vertex.
template <class Real, SimplexHandle Simplex>
[[nodiscard]] bool is_boundary(const Complex<Real>& complex, Simplex simplex) {
    return any_edge(complex, simplex, [&](Corner c) { return is_border(complex.twin(c)); });
}

/// An edge is on the interface if its two triangles differ in phase, or if it is on the domain
/// boundary and its triangle's phase is not `exterior_phase` (figure 8.3); a vertex if it has such
/// an edge. The interface has no triangles (thesis, section 4.3): the form for a triangle asks
/// whether one of its edges is on it. O(1); O(degree) for a vertex.
template <class Real, SimplexHandle Simplex>
[[nodiscard]] bool is_interface(const Complex<Real>& complex, Simplex simplex) {
    return any_edge(complex, simplex, [&](Corner c) {
        return is_interface_pair(complex.phase_at(c), complex.phase_at(complex.twin(c)));
    });
}

/// The phases that occur, ascending. O(n).
template <class Real>
[[nodiscard]] std::vector<Phase> phases(const Complex<Real>& complex);

/// The area of all triangles of a phase, summed with compensation in double. O(n).
template <class Real>
[[nodiscard]] double phase_area(const Complex<Real>& complex, Phase phase);

/// One connected component of a phase. Triangles of a phase that share an edge are in the same
/// component; those that share a vertex alone are not.
struct Component {
    Phase phase = exterior_phase; ///< of all its triangles
    std::uint32_t triangles = 0;  ///< how many
    /// The closed curves around the component, including the outer one. Holes that touch at a
    /// vertex share a curve.
    std::uint32_t outlines = 0;
    bool touches_border = false; ///< an edge of the domain boundary belongs to it
    double area = 0;             ///< in squared units of the domain

    /// The outlines without the outer one.
    [[nodiscard]] std::uint32_t holes() const { return outlines - 1; }
};

/// All components of a complex, and which of them each triangle belongs to.
struct Components {
    std::vector<Component> list; ///< in the order of the smallest triangle of each
    /// The position in `list` of each triangle's component, by id; `no_id` where no triangle lives.
    std::vector<std::uint32_t> of;
};

/// The components of all phases, the exterior included. Areas are those that the outlines enclose.
/// O(triangles): one sweep finds the outlines; then all components of a phase but the largest are
/// filled from theirs. The complex must be valid.
template <class Real>
[[nodiscard]] Components components(const Complex<Real>& complex);

/// The connected parts of a complex, numbered in the order of the smallest triangle of each.
struct Parts {
    std::uint32_t count = 0;       ///< of parts
    std::vector<std::uint32_t> of; ///< by id of the triangle; `no_id` where none lives
};

/// `joined(triangle)[i]`, i being the index of the corner opposite to an edge, says whether the two
/// triangles there are in one part; it must be the same for both. It is called once for each
/// triangle, ascending. O(triangles): one sweep by id, in which a triangle takes the smallest
/// number of its neighbours before it, and a second one for numbers that belong to the same part.
template <class Real, class Joined>
[[nodiscard]] Parts label_parts(const Complex<Real>& complex, Joined joined) {
    Parts parts;
    parts.of.resize(complex.triangle_bound(), no_id);
    std::uint32_t* const number_of = parts.of.data();
    std::vector<std::uint32_t> same_as; // a smaller number of the same part, or itself
    const auto smallest = [&](std::uint32_t number) {
        while (same_as[number] != number) {
            number = same_as[number] = same_as[same_as[number]];
        }
        return number;
    };
    const auto bound = static_cast<std::uint32_t>(parts.of.size());
    for (std::uint32_t t = border_triangle + 1; t < bound; ++t) {
        const TriangleRecord& triangle = complex.triangles[t];
        if (triangle.v[0] == no_id) {
            continue;
        }
        const std::array<bool, 3> is_joined = joined(Triangle{t});
        const auto of_neighbour =
            [&](std::uint32_t i) { // no_id: the neighbour comes later, or is not joined
                const std::uint32_t number = number_of[triangle_of(triangle.n[i])];
                return is_joined[i] ? number : no_id;
            };
        const std::array before{of_neighbour(0), of_neighbour(1), of_neighbour(2)};
        std::uint32_t number = std::min(before[0], std::min(before[1], before[2]));
        if (number == no_id) [[unlikely]] {
            number = static_cast<std::uint32_t>(same_as.size());
            same_as.push_back(number);
        }
        const auto is_same = [&](std::uint32_t i) {
            return static_cast<unsigned>(before[i] == number) |
                   static_cast<unsigned>(before[i] == no_id);
        };
        if ((is_same(0) & is_same(1) & is_same(2)) == 0) [[unlikely]] {
            for (const std::uint32_t other : before) {
                if (other != no_id) {
                    const auto [low, high] = std::minmax({smallest(other), smallest(number)});
                    same_as[high] = low;
                }
            }
        }
        number_of[t] = number;
    }
    for (std::uint32_t& number : same_as) { // ascending: the smaller one is final already
        number = &number - same_as.data() == number ? parts.count++ : same_as[number];
    }
    for (std::uint32_t& number : parts.of) {
        number = number == no_id ? no_id : same_as[number];
    }
    return parts;
}

/// A set of half-edges, each named by the corner opposite to it, for walks that take each of them
/// once.
class HalfEdges {
public:
    /// These, in ascending order.
    explicit HalfEdges(std::vector<Corner> ascending) : all_(std::move(ascending)) { index(); }
    /// The half-edges for which `is_edge(corner)` holds. O(triangles).
    template <class Real, class IsEdge>
    HalfEdges(const Complex<Real>& complex, IsEdge is_edge) {
        for (const Triangle t : triangles(complex)) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                add_if(corner_of(t.id, i), is_edge);
            }
        }
        index();
    }
    /// The half-edges for which `is_edge(corner)` holds and that begin at the given vertices.
    /// O(their stars).
    template <class Real, class IsEdge>
    HalfEdges(const Complex<Real>& complex, std::span<const std::uint32_t> from, IsEdge is_edge) {
        for (const std::uint32_t v : from) {
            for_each_corner(complex, Vertex{v}, [&](Corner c) { add_if(prev(c), is_edge); });
        }
        std::ranges::sort(all_);
        all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
        index();
    }

    /// The smallest one that has not been taken; no_id if all have been. Amortised O(1).
    [[nodiscard]] Corner first_left() {
        while (first_ < all_.size() && is_taken_[first_] != 0) {
            ++first_;
        }
        return first_ < all_.size() ? all_[first_] : no_id;
    }
    /// Takes this one. False if it has been taken before, or is not in the set. O(log their
    /// number), and O(1) if their ids are spread evenly.
    bool take(Corner corner) {
        const std::size_t range = corner >> shift_;
        if (range + 1 >= begin_.size()) {
            return false;
        }
        const Corner* const all = all_.data();
        const Corner* const end = all + begin_[range + 1];
        const Corner* const at = std::lower_bound(all + begin_[range], end, corner);
        return at != end && *at == corner &&
               std::exchange(is_taken_[static_cast<std::size_t>(at - all)], 1) == 0;
    }

private:
    template <class IsEdge>
    void add_if(Corner corner, IsEdge is_edge) {
        if (is_edge(corner)) {
            all_.push_back(corner);
        }
    }

    // Divides the ids of corners into as many ranges as there are half-edges, so that few are in
    // each of them.
    void index() {
        is_taken_.resize(all_.size(), 0);
        if (all_.empty()) {
            return;
        }
        shift_ = static_cast<int>(std::bit_width(all_.back() / all_.size()));
        begin_.resize((all_.back() >> shift_) + 2, 0);
        for (const Corner corner : all_) {
            ++begin_[(corner >> shift_) + 1];
        }
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    }

    std::vector<Corner> all_;          ///< ascending
    std::vector<std::uint32_t> begin_; ///< where the corners of each range of ids begin in `all_`
    int shift_ = 0;                    ///< a range has two to this power corners
    std::vector<std::uint8_t> is_taken_;
    std::size_t first_ = 0; ///< all half-edges before it have been taken
};

/// Calls `visit(std::span<const Corner>)` for each closed loop of half-edges for which
/// `is_edge(corner)` holds: those around a region, with the region on their left and not on their
/// right. At each vertex a loop continues with the next edge of the same fan of triangles. A loop
/// begins with its smallest corner, in the triangle inside, and loops are sorted by these corners.
/// O(half-edges, times the logarithm of their number).
template <class Real, class IsEdge, class Visit>
void for_each_loop(const Complex<Real>& complex, HalfEdges half_edges, IsEdge is_edge,
                   Visit visit) {
    std::vector<Corner> loop;
    for (Corner c = half_edges.first_left(); c != no_id; c = half_edges.first_left()) {
        loop.clear();
        for (; half_edges.take(c); c = next_along(complex, c, is_edge)) {
            loop.push_back(c);
        }
        visit(std::span<const Corner>(loop));
    }
}

/// A curve of the interface, with the same two phases along its whole length.
struct InterfaceCurve {
    /// The vertices in order; each is joined to the previous one by an interface edge. A closed
    /// curve does not repeat its first vertex. An open one has two vertices or more; they are
    /// distinct, except for the ends of a curve that returns to its junction.
    std::vector<Vertex> vertices;
    bool is_closed = false;       ///< without ends
    Phase left = exterior_phase;  ///< the larger one; at the domain boundary, the phase inside
    Phase right = exterior_phase; ///< `border_phase` at the domain boundary

    friend bool operator==(const InterfaceCurve&, const InterfaceCurve&) = default;
};

/// The interface as curves. Each interface edge is in exactly one of them: edges between two
/// phases, and edges of the domain boundary with a phase other than `exterior_phase` inside. A
/// curve ends at vertices with more or fewer than two interface edges (junctions, points where a
/// phase touches itself), and a curve between two phases ends at the domain boundary. The domain
/// boundary has separate curves of its own; they continue through its corners.
///
/// Curves come in the order of the smallest corner of the triangles on their left; a closed curve
/// begins where the edge opposite to that corner does. So the same complex gives the same lists,
/// but `renumber` may change their order. O(triangles).
template <class Real>
[[nodiscard]] std::vector<InterfaceCurve> interface_curves(const Complex<Real>& complex);

/// A closed curve; the first vertex is not repeated at the end.
using VertexLoop = std::vector<Vertex>;

/// The outlines of the phases for which `belongs(phase)` holds, taken together: counter-clockwise
/// around them, clockwise around holes, with edges of the domain boundary where they reach it.
/// Where two triangles of these phases meet only at a vertex, two outlines touch, or one passes
/// through it twice. In the order of `for_each_loop`. O(triangles), or O(n log n) in the n vertices
/// of `interface`: these must be all vertices of the interface (`Simulation::interface`), and are
/// used unless the exterior phase belongs.
template <class Real, class Belongs>
[[nodiscard]] std::vector<VertexLoop>
outlines_where(const Complex<Real>& complex, Belongs belongs,
               std::optional<std::span<const std::uint32_t>> interface = {}) {
    std::vector<VertexLoop> loops;
    const auto is_inside = [&](Phase phase) { return phase != border_phase && belongs(phase); };
    const auto is_edge = [&](Corner c) {
        return is_inside(complex.phase_at(c)) && !is_inside(complex.phase_at(complex.twin(c)));
    };
    // Outlines of the exterior also run along the domain boundary, where `interface` has no edges.
    const bool is_listed = interface && !belongs(exterior_phase);
    for_each_loop(complex,
                  is_listed ? HalfEdges(complex, *interface, is_edge) : HalfEdges(complex, is_edge),
                  is_edge, [&](std::span<const Corner> corners) {
                      VertexLoop& loop = loops.emplace_back();
                      for (const Corner c : corners) {
                          loop.push_back(Vertex{complex.vertex(next(c))});
                      }
                  });
    return loops;
}

/// The outlines of one phase.
template <class Real>
[[nodiscard]] std::vector<VertexLoop>
outlines(const Complex<Real>& complex, Phase phase,
         std::optional<std::span<const std::uint32_t>> interface = {}) {
    return outlines_where(
        complex, [phase](Phase other) { return other == phase; }, interface);
}

} // namespace dsc
