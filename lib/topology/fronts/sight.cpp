// SPDX-License-Identifier: MIT
#include "topology/fronts/sight.h"

#include "dsc/queries/phases.h"
#include "topology/fronts/encounter.h"
#include "topology/fronts/front_curve.h"
#include "topology/fronts/front_point.h"
#include "topology/fronts/squeezed.h"
#include "topology/junctions/sectors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc {

namespace {

/// A front sees another within its sector of the film, this far from both of its edges (radians).
constexpr double min_angle = 0.5;
/// A narrower sector (radians) is the end of a seam or the tip of a film, and no front.
constexpr double min_sector = 1.9;
/// Fronts that meet within a sub-step are nearer to each other than this, in edge lengths.
constexpr double max_gap_of_fronts = 1.25;
/// A vertex takes the place of a foot that is nearer than this, in edge lengths.
constexpr double snap = 0.3;
/// Fronts approach if they come closer by this share of their way.
constexpr double min_closing = 0.05;

template <class Real>
class Looking {
public:
    Looking(const TopologyWork<Real>& work, SightScratch<Real>& scratch)
        : work_(work), complex_(work.complex), scratch_(scratch) {}

    [[nodiscard]] std::optional<Sight<Real>> from(std::uint32_t v) const {
        if (!complex_.is_alive(Vertex{v}) || complex_.vertices[v].corner == no_id || !may_see(v) ||
            is_locked(v)) {
            return {};
        }
        Sectors<Real>& sectors = scratch_.here;
        find_sectors(complex_, Vertex{v}, sectors);
        std::optional<Sight<Real>> best;
        if (sectors.is_on_boundary) {
            look_along_boundary(v, sectors, best);
            return best;
        }
        if (sectors.size() < 2) {
            return {};
        }
        for (std::size_t k = 0; k < sectors.size(); ++k) {
            look_into(v, sectors, k, best);
        }
        return best;
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }
    [[nodiscard]] bool is_locked(std::uint32_t v) const {
        return (complex_.vertices[v].flags & vertex_locked) != 0;
    }

    // Whether the star of an interface vertex reaches another front at all: nearly none does.
    [[nodiscard]] bool may_see(std::uint32_t v) const {
        const Real max_gap = static_cast<Real>(max_gap_of_fronts) * work_.edge_length;
        return find_corner(complex_, Vertex{v}, [&](Corner c) {
                   if (!meet_in_points(complex_.phase_at(c))) {
                       return false;
                   }
                   if (is_sheet(complex_, c) || is_border(complex_.twin(prev(c)))) {
                       return true;
                   }
                   const std::uint32_t w = complex_.vertex(next(c));
                   const std::uint32_t noted = work_.notes[Vertex{w}].round;
                   return !is_outline(complex_, prev(c)) &&
                          (noted == work_.round || (noted == 0 && may_be_new(work_, Vertex{w}) &&
                                                    is_interface(complex_, Vertex{w}))) &&
                          (at(w) - at(v)).norm() < Real(1.5) * max_gap;
               }) != no_id;
    }

    void look_into(std::uint32_t v, const Sectors<Real>& sectors, std::size_t k,
                   std::optional<Sight<Real>>& best) const {
        const Sector<Real>& sector = sectors[k];
        if (!meet_in_points(sector.phase)) {
            return;
        }
        if (sectors.size() == 2) {
            const auto end = see_passed_end(work_, scratch_, v, k);
            if (end && (!best || end->gap < best->gap)) {
                best = end;
                return;
            }
        }
        if (sectors.size() == 3) {
            const auto end = see_squeezed(work_, sectors, v, k);
            if (end && (!best || end->gap < best->gap)) {
                best = end;
                return;
            }
        }
        if (sector.angle < min_sector && !is_pocket(sector)) {
            return;
        }
        Corner c = sector.first;
        for (std::size_t i = 0; i < sector.count; ++i, c = corner_ccw(complex_, c)) {
            if (is_sheet(complex_, c)) {
                look_at_edge(v, sectors, k, c, best);
            }
            if (i + 1 < sector.count) {
                look_at_vertex(v, sectors, k, complex_.vertex(prev(c)), Real(-1), best);
            }
        }
    }

    // A triangle of the film that fronts enclose.
    [[nodiscard]] bool is_pocket(const Sector<Real>& sector) const {
        return sector.count == 1 && is_sheet(complex_, sector.first);
    }

    // 0 where fronts must not meet.
    [[nodiscard]] Real contact(Phase film, Phase other) const {
        return within_triangles(work_, contact_of(work_, film, other));
    }

    // Away from both edges of the sector.
    [[nodiscard]] static bool faces(const Sector<Real>& sector, const Point<Real>& towards) {
        const double angle = angle_between(sector.ray, towards);
        return angle >= min_angle && sector.angle - angle >= min_angle;
    }
    // The phase beyond the side of the sector that a direction in it is nearer to.
    [[nodiscard]] static Phase beyond(const Sectors<Real>& sectors, std::size_t k,
                                      const Point<Real>& towards) {
        return angle_between(sectors[k].ray, towards) < sectors[k].angle / 2
                   ? sectors.before(k).phase
                   : sectors.after(k).phase;
    }

    void look_at_edge(std::uint32_t v, const Sectors<Real>& sectors, std::size_t k, Corner c,
                      std::optional<Sight<Real>>& best) const {
        const Sector<Real>& sector = sectors[k];
        const std::uint32_t a = complex_.vertex(next(c));
        const std::uint32_t b = complex_.vertex(prev(c));
        const Point<Real> way = at(b) - at(a);
        const Real length = way.norm();
        const Real share = (at(v) - at(a)).dot(way) / (length * length);
        if (!(share > 0 && share < 1)) {
            return; // an end is nearer
        }
        const Point<Real> across = at(a) + share * way - at(v);
        const Real gap = across.norm();
        const bool encloses = is_sheet(complex_, next(c)) && is_sheet(complex_, prev(c));
        const Point<Real> towards = across / gap;
        if (best && !(gap < best->gap)) {
            return;
        }
        // A pocket closes at the vertex that lies on one of its fronts alone.
        if (encloses ? phase_beyond(complex_, next(c)) != phase_beyond(complex_, prev(c))
                     : !faces(sector, towards)) {
            return;
        }
        const Real near = static_cast<Real>(snap) * work_.edge_length;
        const bool is_first = share < Real(0.5);
        const std::uint32_t end = is_first ? a : b;
        if ((is_first ? share : 1 - share) * length < near && is_inside(sector, end) &&
            look_at_vertex(v, sectors, k, end, gap, best)) {
            if (best && best->v == v && best->q == end) { // where the vertex cannot be the foot
                best->edge = c;
                best->share = share;
            }
            return;
        }
        Sight<Real> sight{.v = v, .edge = c, .share = share, .gap = gap, .film = sector.phase};
        sight.one = beyond(sectors, k, towards);
        sight.other = phase_beyond(complex_, c);
        sight.normal_v = normal_now(work_, v, sector);
        if (!is_behind_squeezed(complex_, sectors, k, sight.other) &&
            closes(sight, towards, encloses)) {
            best = sight;
        }
    }

    // Whether an edge from the sector's vertex to another lies within it.
    [[nodiscard]] bool is_inside(const Sector<Real>& sector, std::uint32_t w) const {
        Corner c = sector.first;
        for (std::size_t i = 0; i + 1 < sector.count; ++i, c = corner_ccw(complex_, c)) {
            if (complex_.vertex(prev(c)) == w) {
                return true;
            }
        }
        return false;
    }

    // `gap`: to a foot near the vertex; negative: to the vertex. False if the vertex is no front.
    bool look_at_vertex(std::uint32_t v, const Sectors<Real>& sectors, std::size_t k,
                        std::uint32_t q, Real gap, std::optional<Sight<Real>>& best) const {
        const Point<Real> way = at(q) - at(v);
        const Real length = way.norm();
        const Real max_gap = static_cast<Real>(max_gap_of_fronts) * work_.edge_length;
        const bool is_at_foot = gap >= 0;
        gap = is_at_foot ? gap : length;
        const Point<Real> towards = way / length;
        if (!(length < Real(1.5) * max_gap) || (best && !(gap < best->gap)) || is_locked(q) ||
            (!is_at_foot && !faces(sectors[k], towards))) {
            return true;
        }
        Sectors<Real>& there = scratch_.there;
        find_sectors(complex_, Vertex{q}, there);
        if (there.size() < 2 || there.is_on_boundary) {
            return true;
        }
        for (std::size_t i = 0; i < there.size(); ++i) {
            const Sector<Real>& sector = there[i];
            const Point<Real> back = -towards;
            if (sector.phase != sectors[k].phase ||
                angle_between(sector.ray, back) >= sector.angle) {
                continue;
            }
            if (sector.angle < min_sector || (!is_at_foot && !faces(sector, back))) {
                return false;
            }
            Sight<Real> sight{.v = v, .q = q, .gap = gap, .film = sector.phase};
            sight.one = beyond(sectors, k, towards);
            sight.other = beyond(there, i, back);
            sight.normal_v = normal_now(work_, v, sectors[k]);
            sight.normal_q = normal_now(work_, q, sector);
            sight.front_q = at(q);
            if (!is_behind_squeezed(complex_, sectors, k, sight.other) &&
                !is_behind_squeezed(complex_, there, i, sight.one) &&
                closes(sight, towards, false)) {
                best = sight;
            }
            return true;
        }
        return true;
    }

    // From the end of a front on the domain boundary along it, with the domain on the left, to the
    // end of another.
    void look_along_boundary(std::uint32_t v, const Sectors<Real>& sectors,
                             std::optional<Sight<Real>>& best) const {
        if (sectors.size() < 2 || sectors.is_at_corner) {
            return;
        }
        const Phase film = sectors[0].phase;
        Corner edge = prev(sectors[0].first); // leaves v
        Sectors<Real>& there = scratch_.there;
        for (int i = 0; i < edges_along_boundary && is_border(complex_.twin(edge)); ++i) {
            const std::uint32_t q = complex_.vertex(prev(edge));
            find_sectors(complex_, Vertex{q}, there);
            if (!there.is_on_boundary || there.is_at_corner || is_locked(q)) {
                return;
            }
            if (there.size() > 1) {
                const Point<Real> way = at(q) - at(v);
                const Real gap = way.norm();
                Sight<Real> sight{.v = v, .q = q, .gap = gap, .film = film};
                sight.one = sectors[1].phase;
                sight.other = there[there.size() - 2].phase;
                sight.front_q = at(q);
                sight.normal_v = way / gap;
                sight.normal_q = -way / gap;
                sight.is_on_boundary = true;
                if (gap < static_cast<Real>(max_gap_of_fronts) * work_.edge_length &&
                    closes(sight, Point<Real>(way / gap), false)) {
                    best = sight;
                }
                return;
            }
            const Corner at_q = find_corner(
                complex_, Vertex{q}, [&](Corner c) { return is_border(complex_.twin(prev(c))); });
            if (at_q == no_id) {
                return;
            }
            edge = prev(at_q);
        }
    }

    // Whether the fronts meet now, or would in another sub-step like the last one; notes their
    // speeds. A pocket closes in any case.
    bool closes(Sight<Real>& sight, const Point<Real>& towards, bool is_enclosed) const {
        const Real reach =
            std::min(contact(sight.film, sight.one), contact(sight.film, sight.other));
        if (!(reach > 0) || !meet_in_points(sight.film) || sight.one == sight.other ||
            sight.one == border_phase || sight.other == border_phase || sight.film == sight.one ||
            sight.film == sight.other) {
            return false;
        }
        const FrontPoint<Real> own = front_point<Real>(sight.v);
        const FrontPoint<Real> other = sight.q != no_id
                                           ? front_point<Real>(sight.q)
                                           : front_point(complex_, sight.edge, sight.share);
        const auto own_way = way_of(work_, own);
        const auto other_way = way_of(work_, other);
        const Point<Real> none = Point<Real>::Zero();
        const Real closing = (own_way.value_or(none) - other_way.value_or(none)).dot(towards);
        const Real way = own_way.value_or(none).norm() + other_way.value_or(none).norm();
        const bool has_blocked = is_blocked(work_, own) || is_blocked(work_, other);
        if (!has_blocked && !is_enclosed && work_.options.opening == Opening::squeezed &&
            !(own_way && other_way && closing > static_cast<Real>(min_closing) * way)) {
            return false;
        }
        const auto speed_v = speed_of(work_, own, sight.normal_v);
        if (sight.q == no_id) {
            const CurvePoint<Real> front =
                curve_now(work_, sight.edge, sight.share, speed_v.value_or(Real(0)));
            sight.front_q = front.place;
            sight.normal_q = front.normal;
        }
        const auto speed_q = speed_of(work_, other, sight.normal_q);
        sight.speed_v = speed_v.value_or(speed_q.value_or(Real(0)));
        sight.speed_q = speed_q.value_or(speed_v.value_or(Real(0)));
        sight.lead_v = lead_of(work_, own, sight.normal_v, sight.speed_v);
        if (sight.q != no_id) {
            sight.lead_q = lead_of(work_, other, sight.normal_q, sight.speed_q);
        }
        if (is_enclosed || sight.gap < std::max(reach, closing)) {
            return true;
        }
        // Fronts at an angle meet sooner: the place comes towards the vertex along the other front.
        const auto met = encounter_of(sight, at(sight.v));
        return met && met->shares < 1;
    }

    const TopologyWork<Real>& work_;
    const Complex<Real>& complex_;
    SightScratch<Real>& scratch_;
};

} // namespace

template <class Real>
std::optional<Sight<Real>> see_front(const TopologyWork<Real>& work, SightScratch<Real>& scratch,
                                     std::uint32_t v) {
    return Looking<Real>(work, scratch).from(v);
}

template std::optional<Sight<double>> see_front(const TopologyWork<double>&, SightScratch<double>&,
                                                std::uint32_t);
template std::optional<Sight<float>> see_front(const TopologyWork<float>&, SightScratch<float>&,
                                               std::uint32_t);

} // namespace dsc
