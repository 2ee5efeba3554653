// SPDX-License-Identifier: MIT
#include "topology/landing/landing.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/submesh.h"
#include "dsc/geometry/predicates.h"
#include "dsc/operations/edge_split.h"
#include "topology/junctions/merging.h"
#include "topology/landing/slits.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace dsc {

namespace {

/// A vertex lands on the domain boundary if it is lower than this, in edge lengths.
constexpr double landing_height = 0.15;
/// It lands on a boundary vertex that is nearer than this fraction of the boundary edge, or of the
/// edge length if that is less.
constexpr double landing_share = 0.25;
/// It lands, blocked or not, if it is nearer than this to the end of its curve, in edge lengths.
/// The direction of a shorter edge is little more than rounding, and so is the end's velocity.
constexpr double end_of_way = 0.01;
/// The same above the boundary edge at that end: a flatter triangle there is never mended.
constexpr double end_of_height = 0.05;
/// Vertices up to this far from the end of the curve, along it, in edge lengths, land first.
constexpr double landing_reach = 1.5;

template <class Real>
class Landing {
public:
    Landing(TopologyWork<Real>& work, std::span<const Candidate> candidates)
        : work_(work), complex_(work.complex), candidates_(candidates) {}

    void run() {
        std::vector<std::tuple<Real, Real, std::uint32_t>> found;
        const auto take = [&](std::uint32_t v) {
            if (is_to_land(v)) {
                found.emplace_back(at(v).x(), at(v).y(), v);
            }
        };
        for (const auto& candidate : candidates_) {
            const Vertex v{candidate.vertex};
            take(v.id);
            if (complex_.is_alive(v) && is_end(v.id)) {
                for_each_corner(complex_, v, [&](Corner c) {
                    if (is_outline(complex_, prev(c))) {
                        take(complex_.vertex(next(c)));
                    }
                });
            }
        }
        std::ranges::sort(found);
        for (const auto& one : found) {
            std::uint32_t v = std::get<2>(one);
            while (v != no_id && is_to_land(v)) {
                if (is_blocked(work_, v) || is_before_held_end(v)) {
                    land_those_before(v);
                }
                v = land(v);
            }
        }
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    [[nodiscard]] bool is_to_land(std::uint32_t v) const {
        return is_blocked(work_, v) || is_before_held_end(v) || has_come_to_end(v);
    }

    // Whether the vertex has all but reached the domain boundary beside its curve's end there, or
    // that end. Vertices of the film may lie in between, pressed flat: they stop nothing.
    [[nodiscard]] bool has_come_to_end(std::uint32_t v) const {
        const Real near = static_cast<Real>(end_of_way) * work_.edge_length;
        const Real low = static_cast<Real>(end_of_height) * work_.edge_length;
        if (!complex_.is_alive(Vertex{v}) || complex_.is_locked(Vertex{v}) || is_on_boundary(v)) {
            return false;
        }
        return find_corner(complex_, Vertex{v}, [&](Corner c) {
                   const std::uint32_t end = complex_.vertex(next(c));
                   return is_sheet(complex_, prev(c)) && is_on_boundary(end) &&
                          ((at(end) - at(v)).squaredNorm() < near * near ||
                           height_above(v, end, Sides::boundary) < low);
               }) != no_id;
    }

    // If the end of a curve is blocked, the next vertices of its own curves are in its way.
    [[nodiscard]] bool is_before_held_end(std::uint32_t v) const {
        return !work_.blocked.empty() && complex_.is_alive(Vertex{v}) &&
               find_corner(complex_, Vertex{v}, [&](Corner c) {
                   const std::uint32_t end = complex_.vertex(next(c));
                   return is_sheet(complex_, prev(c)) && is_blocked(work_, end) && is_end(end);
               }) != no_id;
    }

    [[nodiscard]] bool is_on_boundary(std::uint32_t v) const {
        return dsc::is_on_boundary(complex_, Vertex{v});
    }
    // Where a curve ends.
    [[nodiscard]] bool is_end(std::uint32_t v) const {
        return is_on_boundary(v) || is_junction(complex_, Vertex{v});
    }

    // Between a blocked vertex and the end of its curve there may be vertices of an equally small
    // height that are not blocked. These land first, starting at the end of the curve.
    void land_those_before(std::uint32_t v) {
        std::vector<std::vector<std::uint32_t>> ways;
        for_each_corner(complex_, Vertex{v}, [&](Corner c) {
            if (is_outline(complex_, prev(c))) {
                ways.push_back(way_to_end(prev(c)));
            }
        });
        for (const auto& way : ways) {
            (void)std::all_of(way.rbegin(), way.rend(),
                              [this](std::uint32_t u) { return land(u) != no_id; });
        }
    }

    // The vertices along the curve from the end of the half-edge up to the domain boundary
    // (excluded), if that is near.
    [[nodiscard]] std::vector<std::uint32_t> way_to_end(Corner c) const {
        std::vector<std::uint32_t> way;
        Real length = direction(complex_, c).norm();
        while (length < static_cast<Real>(landing_reach) * work_.edge_length) {
            const std::uint32_t u = complex_.vertex(prev(c));
            if (is_on_boundary(u)) {
                return way;
            }
            if (std::ranges::find(way, u) != way.end()) {
                break; // a closed curve, which may be far shorter than the reach
            }
            way.push_back(u);
            c = along_outline(complex_, c);
            length += direction(complex_, c).norm();
        }
        return {};
    }

    // Lands the vertex, if possible; returns the next vertex of the curve if it has landed.
    std::uint32_t land(std::uint32_t v) {
        fill_slits(work_, v);
        std::vector<std::tuple<Real, Real, Real, std::uint32_t>> neighbours;
        Corner curve = no_id;
        for_each_corner(complex_, Vertex{v}, [&](Corner c) {
            if (is_outline(complex_, prev(c))) {
                curve = prev(c);
                const std::uint32_t w = complex_.vertex(next(c));
                neighbours.emplace_back((at(w) - at(v)).squaredNorm(), at(w).x(), at(w).y(), w);
            }
        });
        if (neighbours.size() != 2 || is_on_boundary(v) || !(contact_at(work_, curve) > 0)) {
            return no_id;
        }
        std::ranges::sort(neighbours); // the nearer one first
        for (const std::size_t i : {0U, 1U}) {
            const std::uint32_t end = std::get<3>(neighbours[i]);
            if (is_end(end) && land_beside(v, end)) {
                return std::get<3>(neighbours[1 - i]);
            }
        }
        return no_id;
    }

    // The boundary edge, among those at the end of a curve, that lies below the vertex.
    struct Below {
        Corner edge = no_id; ///< the corner at the vertex
        std::uint32_t other = no_id;
        Real share = 0; ///< of the way along it
        Real near = 0;  ///< up to this share of the edge, a foot is near an end
    };
    [[nodiscard]] Below find_below(std::uint32_t v, std::uint32_t end) const {
        Below found;
        for_each_corner(complex_, Vertex{v}, [&](Corner c) {
            const bool is_first = complex_.vertex(next(c)) == end;
            if (!is_border(complex_.twin(c)) || !(is_first || complex_.vertex(prev(c)) == end)) {
                return;
            }
            const std::uint32_t other = complex_.vertex(is_first ? prev(c) : next(c));
            const Point<Real> way = at(other) - at(end);
            const Point<Real> from = at(v) - at(end);
            const Real share = from.dot(way) / way.squaredNorm();
            if (found.edge == no_id || share > found.share) {
                const Real near = std::min(Real(1), work_.edge_length / way.norm());
                found = {c, other, share, static_cast<Real>(landing_share) * near};
            }
        });
        return found;
    }

    enum class Sides : std::uint8_t { boundary, all };

    // The height of the vertex above the domain boundary, or also above the other curves that leave
    // the curve's end towards it; or its distance from that end.
    [[nodiscard]] Real height_above(std::uint32_t v, std::uint32_t end, Sides sides) const {
        const Point<Real> from = at(v) - at(end);
        Real lowest = from.norm();
        for_each_corner(complex_, Vertex{end}, [&](Corner c) {
            for (const Corner side : {next(c), prev(c)}) {
                const std::uint32_t other = complex_.vertex(side == next(c) ? prev(c) : next(c));
                const Point<Real> way = at(other) - at(end);
                const bool counts = is_border(complex_.twin(side)) ||
                                    (sides == Sides::all && is_sheet(complex_, side));
                if (other != v && counts && from.dot(way) > 0) {
                    lowest = std::min(lowest, std::abs(cross<Real>(way, from)) / way.norm());
                }
            }
        });
        return lowest;
    }

    // Removes vertices of the film between the edge and the domain boundary, as far as they may be
    // removed.
    void make_way(std::uint32_t v, std::uint32_t end) {
        std::vector<std::uint32_t> link; // from side to side
        for_each_corner(complex_, Vertex{end}, [&](Corner c) {
            link.push_back(complex_.vertex(next(c)));
            if (is_border(complex_.twin(next(c)))) {
                link.push_back(complex_.vertex(prev(c)));
            }
        });
        const auto place = std::ranges::find(link, v);
        const bool is_first = (at(v) - at(end)).dot(at(link.front()) - at(end)) > 0;
        const std::span between = is_first ? std::span(link.begin(), place).subspan(1)
                                           : std::span(place + 1, link.end() - 1);
        for (const std::uint32_t u : between) {
            (void)remove_inside(work_, Vertex{u}, Real(0));
        }
    }

    bool land_beside(std::uint32_t v, std::uint32_t end) {
        Below below = find_below(v, end);
        const Real height = height_above(v, end, Sides::all);
        if (!(height < static_cast<Real>(landing_height) * work_.edge_length)) {
            return false;
        }
        if (below.edge == no_id && is_on_boundary(end)) {
            make_way(v, end);
            below = find_below(v, end);
        }
        Event event{.kind = EventKind::widen,
                    .time = work_.time,
                    .x = static_cast<double>(at(v).x()),
                    .y = static_cast<double>(at(v).y())};
        std::uint32_t target = end;
        if (below.edge != no_id && below.share > below.near) {
            // The phase across the edge from the vertex to the end of the curve takes the wedge.
            const Corner side =
                complex_.vertex(next(below.edge)) == end ? prev(below.edge) : next(below.edge);
            const Phase taker = complex_.phase_at(complex_.twin(side));
            event.lost = complex_.phase_at(below.edge);
            event.taken = {taker, taker};
            if (!may_open(work_, {.film = event.lost,
                                  .sides = {taker, border_phase},
                                  .x = event.x,
                                  .y = event.y,
                                  .thickness = static_cast<double>(height)})) {
                return false;
            }
            target = foot_of(below, end);
            event.area = give_wedge(v, end, target, taker);
        }
        const std::size_t transfers = work_.transfers.size();
        const bool has_landed = merge_ends(work_, Vertex{v}, Vertex{target}, false).is_valid();
        forget_landing(work_, transfers);
        if (target != end) {
            work_.events.push_back(event);
        }
        if (has_landed) {
            touch(work_, Vertex{target}); // its star may be slender
        }
        return has_landed;
    }

    // The boundary vertex below the one that lands: an existing or a new one.
    std::uint32_t foot_of(const Below& below, std::uint32_t end) {
        if (below.share < 1 - below.near) {
            const Point<Real> foot = at(end) + below.share * (at(below.other) - at(end));
            const SplitResult split = edge_split(submesh_, below.edge, foot);
            if (split.verdict == Verdict::legal) {
                return split.vertex.id;
            }
        }
        return below.other;
    }

    // Gives away the triangle between the curve and the domain boundary, up to `target`; returns
    // its area.
    double give_wedge(std::uint32_t v, std::uint32_t end, std::uint32_t target, Phase taker) {
        const Corner wedge = find_corner(complex_, Vertex{v}, [&](Corner c) {
            const std::uint32_t from = complex_.vertex(next(c));
            const std::uint32_t to = complex_.vertex(prev(c));
            return (from == end && to == target) || (to == end && from == target);
        });
        const Triangle t{triangle_of(wedge)};
        give(work_, t, taker);
        return static_cast<double>(doubled_area(complex_, t)) / 2;
    }

    TopologyWork<Real>& work_;
    Complex<Real>& complex_;
    Submesh<Real> submesh_{complex_};
    std::span<const Candidate> candidates_;
};

} // namespace

template <class Real>
void land_vertices(TopologyWork<Real>& work, std::span<const Candidate> candidates) {
    Landing<Real>(work, candidates).run();
}

template void land_vertices(TopologyWork<double>&, std::span<const Candidate>);
template void land_vertices(TopologyWork<float>&, std::span<const Candidate>);

} // namespace dsc
