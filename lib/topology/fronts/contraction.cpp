// SPDX-License-Identifier: MIT
#include "topology/fronts/contraction.h"

#include "dsc/complex/submesh.h"
#include "dsc/geometry/predicates.h"
#include "dsc/operations/edge_flip.h"
#include "topology/junctions/mending.h"
#include "topology/junctions/merging.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <tuple>

namespace dsc {

namespace {

/// Below this height over the longest edge, vertices inside a phase make room, and edges flip.
constexpr double poor_height = 0.02;
constexpr int max_cleared = 7;
/// Below this one the star is mended at once.
constexpr double slender = 0.1;

template <class Real>
class Contraction {
public:
    explicit Contraction(TopologyWork<Real>& work)
        : work_(work), complex_(work.complex), submesh_(work.complex) {}

    std::uint32_t run(std::uint32_t v, std::uint32_t q, const Point<Real>& place) {
        for (int removed = 0; removed <= max_cleared; ++removed) {
            const Corner edge = edge_between(v, q);
            if (edge == no_id) {
                return no_id;
            }
            const bool is_inside = !is_border(complex_.twin(edge));
            const bool has_side_v = is_on_boundary(complex_, Vertex{v});
            const bool has_side_q = is_on_boundary(complex_, Vertex{q});
            if (is_inside && has_side_v && has_side_q) {
                return no_id; // the domain would be pinched
            }
            std::vector<std::uint32_t> common;
            std::ranges::set_intersection(link_of(complex_, v), link_of(complex_, q),
                                          std::back_inserter(common));
            if (common.size() != (is_inside ? 2U : 1U)) { // a vertex may be in the way
                if (!clear(common, v, q, edge)) {
                    return no_id;
                }
                continue;
            }
            const Worst of_v = worst_at(v, q, place);
            const Worst of_q = worst_at(q, v, place);
            const Worst& worst = of_v.height <= of_q.height ? of_v : of_q;
            if (worst.height < static_cast<Real>(poor_height) && removed < max_cleared &&
                (remove(complex_.vertex(next(worst.corner))) ||
                 remove(complex_.vertex(prev(worst.corner))) || flip_away(worst, place))) {
                continue;
            }
            if (!(worst.height > 0)) {
                return no_id;
            }
            note_sweep(work_, Vertex{v}, Vertex{q}, place);
            note_sweep(work_, Vertex{q}, Vertex{v}, place);
            const auto order = [&](std::uint32_t w) { return std::tuple(at(w).x(), at(w).y()); };
            const bool keeps_v = has_side_v != has_side_q ? has_side_v : order(v) < order(q);
            const std::uint32_t kept = keeps_v ? v : q;
            rewire::collapse(complex_, complex_.journal, edge,
                             complex_.vertex(next(edge)) == kept ? rewire::Vanishing::prev
                                                                 : rewire::Vanishing::next,
                             complex_.ids);
            rewire::move(complex_, complex_.journal, kept, place.x(), place.y(), MoveReason::flow);
            settle(kept);
            if (worst.height < static_cast<Real>(slender)) {
                mend_star(work_, Vertex{kept});
            }
            return kept;
        }
        return no_id;
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    // Opposite to the edge between two vertices.
    [[nodiscard]] Corner edge_between(std::uint32_t v, std::uint32_t q) const {
        const Corner c = find_corner(complex_, Vertex{v}, [&](Corner k) {
            return complex_.vertex(next(k)) == q || complex_.vertex(prev(k)) == q;
        });
        return c == no_id ? no_id : complex_.vertex(next(c)) == q ? prev(c) : next(c);
    }

    bool remove(std::uint32_t inside) { return remove_inside(work_, Vertex{inside}, Real(0)); }
    // Unless the edge bounds a phase.
    bool flip(Corner edge) { return edge_flip(submesh_, edge) == Verdict::legal; }

    // Takes a common neighbour of v and q that is no apex of their edge out of the link of one.
    bool clear(std::span<const std::uint32_t> common, std::uint32_t v, std::uint32_t q,
               Corner edge) {
        return std::ranges::any_of(common, [&](std::uint32_t x) { return remove(x); }) ||
               std::ranges::any_of(common, [&](std::uint32_t x) {
                   return x != complex_.vertex(edge) && x != complex_.vertex(complex_.twin(edge)) &&
                          (flip(edge_between(v, x)) || flip(edge_between(q, x)));
               });
    }

    /// Height over longest edge of the worst triangle.
    struct Worst {
        Real height = 1;
        Corner corner = no_id;
    };
    // Of the star of v with v at a place, without the triangles that have q.
    [[nodiscard]] Worst worst_at(std::uint32_t v, std::uint32_t q, const Point<Real>& place) const {
        Worst worst;
        for_each_corner(complex_, Vertex{v}, [&](Corner c) {
            const std::uint32_t a = complex_.vertex(next(c));
            const std::uint32_t b = complex_.vertex(prev(c));
            if (a == q || b == q) {
                return;
            }
            const Real height = height_over_longest<Real>(place, at(a), at(b));
            if (height < worst.height) {
                worst = {height, c};
            }
        });
        return worst;
    }

    // Takes the worst triangle out of the star by a flip, if that leaves a better one there: where
    // two vertices of the seam are in the star, and the place is on their line.
    bool flip_away(const Worst& worst, const Point<Real>& place) {
        for (const Corner c : {next(worst.corner), prev(worst.corner)}) { // opposite to the edge
            const Corner across = complex_.twin(c);
            if (is_border(across)) {
                continue;
            }
            const bool is_first = c == next(worst.corner);
            const Point<Real> a = at(complex_.vertex(is_first ? c : across));
            const Point<Real> b = at(complex_.vertex(is_first ? across : c));
            if (height_over_longest<Real>(place, a, b) > worst.height && flip(c)) {
                return true;
            }
        }
        return false;
    }

    // The vertex, and the vertices around it, are not blocked any more.
    void settle(std::uint32_t kept) {
        complex_.vertices[kept].flags &=
            ~static_cast<std::uint32_t>(vertex_contact | vertex_feature | vertex_on_way);
        work_.notes[Vertex{kept}].round = 0; // where it was before says nothing about a front
        touch(work_, Vertex{kept});
        for (const std::uint32_t w : link_of(complex_, kept)) {
            complex_.vertices[w].flags &= ~static_cast<std::uint32_t>(vertex_contact);
        }
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_;
};

} // namespace

template <class Real>
std::uint32_t contract(TopologyWork<Real>& work, std::uint32_t v, std::uint32_t q,
                       const Point<Real>& place) {
    return Contraction<Real>(work).run(v, q, place);
}

template <class Real>
std::vector<std::uint32_t> link_of(const Complex<Real>& complex, std::uint32_t v) {
    std::vector<std::uint32_t> link;
    for_each_corner(complex, Vertex{v}, [&](Corner c) {
        link.push_back(complex.vertex(next(c)));
        link.push_back(complex.vertex(prev(c)));
    });
    std::ranges::sort(link);
    link.erase(std::unique(link.begin(), link.end()), link.end());
    return link;
}

template std::uint32_t contract(TopologyWork<double>&, std::uint32_t, std::uint32_t,
                                const Point<double>&);
template std::uint32_t contract(TopologyWork<float>&, std::uint32_t, std::uint32_t,
                                const Point<float>&);
template std::vector<std::uint32_t> link_of(const Complex<double>&, std::uint32_t);
template std::vector<std::uint32_t> link_of(const Complex<float>&, std::uint32_t);

} // namespace dsc
