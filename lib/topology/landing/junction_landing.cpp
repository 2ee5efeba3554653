// SPDX-License-Identifier: MIT
#include "topology/landing/landing.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/submesh.h"
#include "dsc/geometry/side.h"
#include "dsc/operations/edge_split.h"
#include "topology/fronts/contraction.h"

#include <limits>
#include <optional>
#include <utility>

namespace dsc {

namespace {

/// A junction lands if it is lower than this, in edge lengths.
constexpr double landing_height_of_junction = 0.05;
/// It lands on a vertex of the side that is nearer than this share of the edge.
constexpr double end_of_edge = 0.1;

template <class Real>
class JunctionLanding {
public:
    explicit JunctionLanding(TopologyWork<Real>& work)
        : work_(work), complex_(work.complex), submesh_(work.complex) {}

    void run(std::uint32_t v) {
        const Corner below = find_corner(complex_, Vertex{v}, [&](Corner c) {
            return is_border(complex_.twin(c)) &&
                   thickness(complex_, Triangle{triangle_of(c)}) < near();
        });
        if (below != no_id) {
            land_on_edge(v, below);
        } else {
            land_at_neighbour(v);
        }
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }
    [[nodiscard]] Real near() const {
        return static_cast<Real>(landing_height_of_junction) * work_.edge_length;
    }
    [[nodiscard]] static bool is_between_ends(Real share) {
        return share >= static_cast<Real>(end_of_edge) &&
               share <= 1 - static_cast<Real>(end_of_edge);
    }

    // On the edge opposite to the corner at the junction.
    void land_on_edge(std::uint32_t v, Corner c) {
        if (!may_land(v, complex_.phase_at(c))) {
            return;
        }
        const Point<Real> from = at(complex_.vertex(next(c)));
        const Point<Real> way = direction(complex_, c);
        const Real share = (at(v) - from).dot(way) / way.squaredNorm();
        if (!is_between_ends(share)) {
            const std::uint32_t end = complex_.vertex(share < Real(0.5) ? next(c) : prev(c));
            join(v, end, at(end));
            return;
        }
        const SplitResult split = edge_split(submesh_, c, Point<Real>(from + share * way));
        if (split.verdict == Verdict::legal) {
            join(v, split.vertex.id, at(split.vertex.id));
        }
    }

    // On the nearest vertex of the side that is a neighbour, which slides below the junction: the
    // edge between them is short, or lies along the side, as the last one of a front does.
    void land_at_neighbour(std::uint32_t v) {
        Corner nearest = no_id; // whose next vertex is that neighbour
        Real best = std::numeric_limits<Real>::max();
        for_each_corner(complex_, Vertex{v}, [&](Corner c) {
            const std::uint32_t end = complex_.vertex(next(c));
            const Real distance = (at(end) - at(v)).squaredNorm();
            if (distance < best && foot_beside(end, at(v))) {
                best = distance;
                nearest = c;
            }
        });
        if (nearest != no_id && may_land(v, complex_.phase_at(nearest)) &&
            may_land(v, phase_beyond(complex_, prev(nearest)))) {
            const std::uint32_t end = complex_.vertex(next(nearest));
            join(v, end, *foot_beside(end, at(v)));
        }
    }

    // The foot of a place on the side at a vertex, which may slide there if the side is straight;
    // none if the place is too far away, or the vertex is none of a side.
    [[nodiscard]] std::optional<Point<Real>> foot_beside(std::uint32_t end,
                                                         const Point<Real>& place) const {
        std::uint32_t before = no_id;
        std::uint32_t after = no_id;
        (void)find_corner(complex_, Vertex{end}, [&](Corner c) {
            before = is_border(complex_.twin(next(c))) ? complex_.vertex(prev(c)) : before;
            after = is_border(complex_.twin(prev(c))) ? complex_.vertex(next(c)) : after;
            return false; // all of them, in any order
        });
        if (before == no_id || after == no_id) {
            return {};
        }
        Point<Real> foot = at(end);
        if (!complex_.is_locked(Vertex{end}) &&
            side_at<Real>(at(before), foot, at(after), false) == Side::straight) {
            const Point<Real> way = at(after) - at(before);
            const Real share = (place - at(before)).dot(way) / way.squaredNorm();
            if (is_between_ends(share)) {
                foot = at(before) + share * way;
            }
        }
        return (place - foot).squaredNorm() < near() * near() ? std::optional(foot) : std::nullopt;
    }

    // Asks for each phase that takes the film below the junction.
    [[nodiscard]] bool may_land(std::uint32_t v, Phase film) const {
        return find_corner(complex_, Vertex{v}, [&](Corner c) {
                   const Phase taker = complex_.phase_at(c);
                   return taker != film &&
                          !(contact_of(work_, film, taker) > 0 &&
                            may_open(work_, {.film = film,
                                             .sides = {taker, border_phase},
                                             .x = static_cast<double>(at(v).x()),
                                             .y = static_cast<double>(at(v).y())}));
               }) == no_id;
    }

    void join(std::uint32_t v, std::uint32_t end, const Point<Real>& place) {
        const std::size_t transfers = work_.transfers.size();
        (void)contract<Real>(work_, v, end, place);
        forget_landing(work_, transfers);
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_;
};

} // namespace

template <class Real>
void land_junctions(TopologyWork<Real>& work, std::span<const Candidate> candidates) {
    JunctionLanding<Real> landing(work);
    for (const Candidate& candidate : candidates) {
        const Vertex v{candidate.vertex};
        if (work.complex.is_alive(v) && !work.complex.is_locked(v) &&
            is_junction(work.complex, v) && !is_on_boundary(work.complex, v)) {
            landing.run(v.id);
        }
    }
}

template void land_junctions(TopologyWork<double>&, std::span<const Candidate>);
template void land_junctions(TopologyWork<float>&, std::span<const Candidate>);

} // namespace dsc
