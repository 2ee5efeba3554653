// SPDX-License-Identifier: MIT
#include "topology/fronts/meeting.h"

#include "dsc/complex/submesh.h"
#include "dsc/geometry/side.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_split.h"
#include "topology/candidates.h"
#include "topology/fronts/contraction.h"
#include "topology/fronts/encounter.h"
#include "topology/fronts/front_point.h"
#include "topology/fronts/sight.h"
#include "topology/fronts/squeezed.h"
#include "topology/junctions/junction_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

namespace dsc {

namespace {

/// A pocket beside a seam has no more edges than this on each side.
constexpr int edges_of_pocket = 6;

template <class Real>
class Meeting {
public:
    explicit Meeting(TopologyWork<Real>& work)
        : work_(work), complex_(work.complex), submesh_(work.complex) {}

    void run() {
        for (const auto& first : vertices_that_see()) {
            std::vector<std::uint32_t> ahead{std::get<3>(first)};
            begun_ = work_.events.size();
            // Each that joins takes a vertex away or makes one of an edge, which joins once.
            for (std::size_t left = 8 * work_.interface.size(); !ahead.empty() && left > 0;
                 --left) {
                const std::uint32_t next = ahead.back();
                ahead.pop_back();
                if (const auto sight = see_front(work_, next);
                    sight && (work_.options.follows_seams || !is_beside_seam(next, *sight))) {
                    const std::uint32_t kept = join(*sight);
                    if (kept != no_id && work_.options.follows_seams) {
                        add_around(kept, ahead);
                    }
                }
            }
        }
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    // Those with the smallest gap come first: the gap, the place and the vertex.
    auto vertices_that_see() const {
        using Found = std::tuple<Real, Real, Real, std::uint32_t>;
        std::vector<Found> found;
        const auto look = [this](std::uint32_t v, std::vector<Found>& part) {
            if (const auto sight = see_front(work_, v)) {
                part.emplace_back(sight->gap, at(v).x(), at(v).y(), v);
            }
        };
        find_at(work_.in_shares, work_.interface, found, look);
        std::ranges::sort(found);
        return found;
    }

    // The neighbours of a vertex of a seam, in the order of their places.
    void add_around(std::uint32_t kept, std::vector<std::uint32_t>& ahead) const {
        std::vector<std::tuple<Real, Real, std::uint32_t>> around;
        for (const std::uint32_t w : link_of(complex_, kept)) {
            around.emplace_back(at(w).x(), at(w).y(), w);
        }
        around.emplace_back(at(kept).x(), at(kept).y(), kept);
        std::ranges::sort(around, std::greater{});
        for (const auto& one : around) {
            ahead.push_back(std::get<2>(one));
        }
    }

    // The place on the bisector of the two fronts that both reach at the same time, each along its
    // normal, on the way from one to the other.
    [[nodiscard]] static Encounter<Real> meeting_of(const Sight<Real>& sight, const Point<Real>& v,
                                                    const Point<Real>& q) {
        const Speeds speeds = speeds_of(sight);
        const Real gap = (q - v).norm();
        const Real shares = (gap + sight.lead_v + sight.lead_q) / (speeds.v + speeds.q);
        const Real offset = std::clamp(shares * speeds.v - sight.lead_v, Real(0), gap);
        // Exact along an axis.
        const Point<Real> p = gap > 0 ? Point<Real>(v + offset / gap * (q - v)) : v;
        if (sight.is_on_boundary) {
            return {.place = side_at<Real>(v, p, q, false) == Side::straight ? p : v,
                    .shares = speeds.are_known ? shares : Real(0)};
        }
        return meeting_beside(sight, v, q, {.place = p, .shares = shares});
    }
    // Moves a place across the film onto the bisector. Fronts that do not face each other meet
    // where the place is.
    [[nodiscard]] static Encounter<Real> meeting_beside(const Sight<Real>& sight,
                                                        const Point<Real>& v, const Point<Real>& q,
                                                        Encounter<Real> meet) {
        const auto [speed_v, speed_q, are_known] = speeds_of(sight);
        meet.shares = are_known ? meet.shares : Real(0);
        Point<Real> across = sight.normal_v - sight.normal_q;
        const Real size = across.norm();
        if (!(size > Real(0.5))) {
            return meet;
        }
        across /= size;
        const Real rate =
            speed_q * across.dot(sight.normal_v) - speed_v * across.dot(sight.normal_q);
        if (!(std::abs(rate) > 0)) {
            return meet;
        }
        // How far the place is from the fronts now, along their normals.
        const auto from_v = [&] { return (meet.place - v).dot(sight.normal_v) + sight.lead_v; };
        const auto from_q = [&] { return (meet.place - q).dot(sight.normal_q) + sight.lead_q; };
        const Real along = (speed_v * from_q() - speed_q * from_v()) / rate;
        const Real most = (q - v).norm() / 2;
        meet.place += std::clamp(along, -most, most) * across;
        meet.shares = are_known ? (from_v() + from_q()) / (speed_v + speed_q) : Real(0);
        return meet;
    }
    struct Speeds {
        Real v;
        Real q;
        bool are_known; ///< otherwise equal
    };
    [[nodiscard]] static Speeds speeds_of(const Sight<Real>& sight) {
        const Real v = std::max(sight.speed_v, Real(0));
        const Real q = std::max(sight.speed_q, Real(0));
        return v + q > 0 ? Speeds{v, q, true} : Speeds{1, 1, false};
    }

    // Returns the vertex that is left; none if triangles are in the way.
    std::uint32_t join(const Sight<Real>& sight) {
        const std::uint32_t v = sight.v;
        Point<Real> foot = Point<Real>::Zero();
        std::array ends{no_id, no_id}; // of the edge
        if (sight.edge == no_id) {
            foot = at(sight.q);
        } else {
            ends = {complex_.vertex(next(sight.edge)), complex_.vertex(prev(sight.edge))};
            foot = (1 - sight.share) * at(ends[0]) + sight.share * at(ends[1]);
        }
        const Point<double> middle = ((at(v) + foot) / Real(2)).template cast<double>();
        if (!may_open(work_, {.film = sight.film,
                              .sides = {sight.one, sight.other},
                              .x = middle.x(),
                              .y = middle.y(),
                              .thickness = static_cast<double>(sight.gap)})) {
            return no_id;
        }
        if (sight.is_on_boundary && !clear_boundary(v, sight.q)) {
            return no_id;
        }
        const double before = work_.swept;
        if (sight.is_passed) {
            const std::uint32_t end = join_end(sight);
            if (end != no_id) {
                tell(sight, end, work_.swept - before);
            }
            work_.swept = before;
            return end;
        }
        if (sight.is_squeezed) {
            const std::uint32_t end = join_ends(sight);
            work_.swept = before;
            return end;
        }
        std::uint32_t kept = sight.q == no_id ? no_id : meet_at(sight, sight.q);
        const Corner edge = find_corner(complex_, Vertex{v}, [&](Corner c) {
            return complex_.vertex(next(c)) == ends[0] && complex_.vertex(prev(c)) == ends[1];
        });
        if (kept == no_id && edge != no_id) {
            const SplitResult split = edge_split(submesh_, edge, foot);
            if (split.verdict == Verdict::legal) {
                Sight<Real> on_edge = sight;
                on_edge.front_q = sight.q == no_id ? sight.front_q : foot;
                kept = meet_at(on_edge, split.vertex.id);
            }
        }
        if (kept != no_id) {
            tell(sight, kept, work_.swept - before);
        }
        work_.swept = before;
        return kept;
    }

    // Joins a vertex to the end of a seam. The end keeps its time ahead and, unless a triangle is
    // in the way, its place, where the fronts met.
    std::uint32_t join_end(const Sight<Real>& sight) {
        const TimeAhead<Real> ahead = work_.ahead[Vertex{sight.q}];
        std::uint32_t kept = contract<Real>(work_, sight.v, sight.q, at(sight.q));
        if (kept == no_id) {
            kept = contract<Real>(work_, sight.v, sight.q, at(sight.v));
        }
        if (kept != no_id) {
            work_.ahead[Vertex{kept}] = ahead;
        }
        return kept;
    }

    // Joins the ends of two seams as the front between them vanishes: the fronts on both sides of
    // it meet there, and a seam between them begins.
    std::uint32_t join_ends(const Sight<Real>& sight) {
        const std::uint32_t kept = contract(work_, sight.v, sight.q, sight.vanishing.place);
        if (kept != no_id) {
            put_ahead(work_, kept, sight.vanishing.shares, sight.speed_v);
            leave_film(work_, Vertex{kept}, sight.film);
        }
        return kept;
    }

    // With a vertex of the other front.
    std::uint32_t meet_at(const Sight<Real>& sight, std::uint32_t q) {
        const std::uint32_t v = sight.v;
        const Point<Real> middle = (at(v) + at(q)) / Real(2);
        Encounter<Real> meet = meeting_of(sight, at(v), sight.front_q);
        std::uint32_t kept = contract(work_, v, q, meet.place);
        if (kept == no_id && !sight.is_on_boundary) {
            // Beside the end of a seam a triangle may be in the way.
            meet = meeting_beside(sight, at(v), sight.front_q, {middle, meet.shares});
            kept = contract(work_, v, q, meet.place);
            if (kept == no_id) {
                kept = contract<Real>(work_, v, q, middle);
            }
        }
        if (kept != no_id) {
            put_ahead(work_, kept, meet.shares, (sight.speed_v + sight.speed_q) / 2);
        }
        return kept;
    }

    // Removes the vertices of the domain boundary between two, on the way from v to q.
    bool clear_boundary(std::uint32_t v, std::uint32_t q) {
        for (int i = 0; i < edges_along_boundary; ++i) {
            const Corner c = find_corner(
                complex_, Vertex{v}, [&](Corner k) { return is_border(complex_.twin(prev(k))); });
            if (c == no_id) {
                return false;
            }
            if (complex_.vertex(next(c)) == q) {
                return true;
            }
            if (edge_collapse(submesh_, prev(c), rewire::Vanishing::prev, BoundaryRule::smooth) !=
                Verdict::legal) {
                return false;
            }
        }
        return false;
    }

    // One event for what closes from one place outwards.
    void tell(const Sight<Real>& sight, std::uint32_t kept, double area) {
        const bool is_new = !is_beside_seam(kept, sight);
        for (std::size_t i = begun_; i < work_.events.size() && !is_new; ++i) {
            Event& event = work_.events[i];
            if (event.lost == sight.film && std::minmax(event.taken[0], event.taken[1]) ==
                                                std::minmax(sight.one, sight.other)) {
                event.area += area;
                return;
            }
        }
        work_.events.push_back({.kind = is_new ? EventKind::meet : EventKind::widen,
                                .time = work_.time,
                                .x = static_cast<double>(at(kept).x()),
                                .y = static_cast<double>(at(kept).y()),
                                .lost = sight.film,
                                .taken = {sight.one, sight.other},
                                .area = area});
    }

    // The vertex belongs to a seam of the same fronts, which begins at it or within a few edges
    // along the film: between them is a pocket, which closes next.
    [[nodiscard]] bool is_beside_seam(std::uint32_t v, const Sight<Real>& sight) const {
        return has_seam(v, sight.one, sight.other) ||
               find_corner(complex_, Vertex{v}, [&](Corner c) {
                   Corner edge = prev(c); // leaves the vertex
                   if (complex_.phase_at(edge) != sight.film || !is_outline(complex_, edge)) {
                       return false;
                   }
                   for (int i = 0; i < edges_of_pocket; ++i) {
                       const std::uint32_t end = complex_.vertex(prev(edge));
                       if (end != v && has_phase(complex_, end, sight.one) &&
                           has_phase(complex_, end, sight.other)) {
                           return true;
                       }
                       edge = along_outline(complex_, edge);
                   }
                   return false;
               }) != no_id;
    }

    // An edge between the two phases reaches the vertex.
    [[nodiscard]] bool has_seam(std::uint32_t v, Phase one, Phase other) const {
        return find_corner(complex_, Vertex{v}, [&](Corner c) {
                   const Corner edge = prev(c);
                   return std::minmax(complex_.phase_at(edge), phase_beyond(complex_, edge)) ==
                          std::minmax(one, other);
               }) != no_id;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_;
    std::size_t begun_ = 0; ///< the first event of the place from which fronts close
};

} // namespace

template <class Real>
void meet_fronts(TopologyWork<Real>& work) {
    Meeting<Real>(work).run();
}

template void meet_fronts(TopologyWork<double>&);
template void meet_fronts(TopologyWork<float>&);

} // namespace dsc
