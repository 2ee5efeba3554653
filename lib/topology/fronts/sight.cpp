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
    Looking(const TopologyWork<Real>& work, std::uint32_t v)
        : work_(work), complex_(work.complex), v_(v) {}

    [[nodiscard]] std::optional<Sight<Real>> nearest() {
        if (!complex_.is_alive(Vertex{v_}) || !may_see() || complex_.is_locked(Vertex{v_})) {
            return {};
        }
        find_sectors(complex_, Vertex{v_}, sectors_);
        if (sectors_.is_on_boundary) {
            look_along_boundary();
            return best_;
        }
        for (std::size_t k = 0; k < sectors_.size(); ++k) {
            look_into(k);
        }
        return best_;
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    // Whether the star of an interface vertex reaches another front at all: nearly none does.
    [[nodiscard]] bool may_see() const {
        const Real max_gap = static_cast<Real>(max_gap_of_fronts) * work_.edge_length;
        return find_corner(complex_, Vertex{v_}, [&](Corner c) {
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
                          (at(w) - at(v_)).norm() < Real(1.5) * max_gap;
               }) != no_id;
    }

    [[nodiscard]] bool is_nearest(Real gap) const { return !best_ || gap < best_->gap; }

    void look_into(std::size_t k) {
        const Sector<Real>& sector = sectors_[k];
        if (!meet_in_points(sector.phase)) {
            return;
        }
        std::optional<Sight<Real>> end; // of a seam
        if (sectors_.size() == 2) {
            end = see_passed_end(work_, sectors_, v_, k);
        } else if (sectors_.size() == 3) {
            end = see_squeezed(work_, sectors_, v_, k);
        }
        if (end && is_nearest(end->gap)) {
            best_ = end;
            return;
        }
        if (sector.angle < min_sector && !is_pocket(sector)) {
            return;
        }
        Corner c = sector.first;
        for (std::size_t i = 0; i < sector.count; ++i, c = corner_ccw(complex_, c)) {
            if (is_sheet(complex_, c)) {
                look_at_edge(k, c);
            }
            if (i + 1 < sector.count) {
                look_at_vertex(k, complex_.vertex(prev(c)), Real(-1));
            }
        }
    }

    // A triangle of the film that fronts enclose.
    [[nodiscard]] bool is_pocket(const Sector<Real>& sector) const {
        return sector.count == 1 && is_sheet(complex_, sector.first);
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

    void look_at_edge(std::size_t k, Corner c) {
        const Sector<Real>& sector = sectors_[k];
        const std::uint32_t a = complex_.vertex(next(c));
        const std::uint32_t b = complex_.vertex(prev(c));
        const Point<Real> way = at(b) - at(a);
        const Real length = way.norm();
        const Real share = (at(v_) - at(a)).dot(way) / (length * length);
        if (!(share > 0 && share < 1)) {
            return; // an end is nearer
        }
        const Point<Real> across = at(a) + share * way - at(v_);
        const Real gap = across.norm();
        const bool encloses = is_sheet(complex_, next(c)) && is_sheet(complex_, prev(c));
        const Point<Real> towards = across / gap;
        if (!is_nearest(gap)) {
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
            look_at_vertex(k, end, gap)) {
            if (best_ && best_->q == end) { // where the vertex cannot be the foot
                best_->edge = c;
                best_->share = share;
            }
            return;
        }
        Sight<Real> sight{.v = v_, .edge = c, .share = share, .gap = gap, .film = sector.phase};
        sight.one = beyond(sectors_, k, towards);
        sight.other = phase_beyond(complex_, c);
        sight.normal_v = normal_now(work_, v_, sector);
        if (!is_behind_squeezed(complex_, sectors_, k, sight.other) &&
            closes(sight, towards, encloses)) {
            best_ = sight;
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
    bool look_at_vertex(std::size_t k, std::uint32_t q, Real gap) {
        const Point<Real> way = at(q) - at(v_);
        const Real length = way.norm();
        const Real max_gap = static_cast<Real>(max_gap_of_fronts) * work_.edge_length;
        const bool is_at_foot = gap >= 0;
        gap = is_at_foot ? gap : length;
        const Point<Real> towards = way / length;
        if (!(length < Real(1.5) * max_gap) || !is_nearest(gap) || complex_.is_locked(Vertex{q}) ||
            (!is_at_foot && !faces(sectors_[k], towards))) {
            return true;
        }
        find_sectors(complex_, Vertex{q}, there_);
        if (there_.is_on_boundary) {
            return true;
        }
        for (std::size_t i = 0; i < there_.size(); ++i) {
            const Sector<Real>& sector = there_[i];
            const Point<Real> back = -towards;
            if (sector.phase != sectors_[k].phase ||
                angle_between(sector.ray, back) >= sector.angle) {
                continue;
            }
            if (sector.angle < min_sector || (!is_at_foot && !faces(sector, back))) {
                return false;
            }
            Sight<Real> sight{.v = v_, .q = q, .gap = gap, .film = sector.phase};
            sight.one = beyond(sectors_, k, towards);
            sight.other = beyond(there_, i, back);
            sight.normal_v = normal_now(work_, v_, sectors_[k]);
            sight.normal_q = normal_now(work_, q, sector);
            sight.front_q = at(q);
            if (!is_behind_squeezed(complex_, sectors_, k, sight.other) &&
                !is_behind_squeezed(complex_, there_, i, sight.one) &&
                closes(sight, towards, false)) {
                best_ = sight;
            }
            return true;
        }
        return true;
    }

    // From the end of a front on the domain boundary along it, with the domain on the left, to the
    // end of another.
    void look_along_boundary() {
        if (sectors_.size() < 2 || sectors_.is_at_corner) {
            return;
        }
        const Phase film = sectors_[0].phase;
        Corner first = sectors_[0].first;
        for (int i = 0; i < edges_along_boundary; ++i) {
            const std::uint32_t q = complex_.vertex(next(first));
            find_sectors(complex_, Vertex{q}, there_);
            if (there_.is_at_corner || complex_.is_locked(Vertex{q})) {
                return;
            }
            if (there_.size() > 1) {
                const Point<Real> way = at(q) - at(v_);
                const Real gap = way.norm();
                Sight<Real> sight{.v = v_, .q = q, .gap = gap, .film = film};
                sight.one = sectors_[1].phase;
                sight.other = there_[there_.size() - 2].phase;
                sight.front_q = at(q);
                sight.normal_v = way / gap;
                sight.normal_q = -way / gap;
                sight.is_on_boundary = true;
                if (gap < static_cast<Real>(max_gap_of_fronts) * work_.edge_length &&
                    closes(sight, sight.normal_v, false)) {
                    best_ = sight;
                }
                return;
            }
            first = there_[0].first;
        }
    }

    // Whether the fronts meet now, or would in another sub-step like the last one; notes their
    // speeds. A pocket closes in any case.
    bool closes(Sight<Real>& sight, const Point<Real>& towards, bool is_enclosed) const {
        const Real reach = contact_of(work_, sight);
        if (!(reach > 0)) {
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
        sight.lead_v = lead_of(work_, sight.v, sight.normal_v, sight.speed_v);
        if (sight.q != no_id) {
            sight.lead_q = lead_of(work_, sight.q, sight.normal_q, sight.speed_q);
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
    std::uint32_t v_;
    Sectors<Real> sectors_; ///< of v
    Sectors<Real> there_;   ///< of a vertex of another front
    std::optional<Sight<Real>> best_;
};

} // namespace

template <class Real>
std::optional<Sight<Real>> see_front(const TopologyWork<Real>& work, std::uint32_t v) {
    return Looking<Real>(work, v).nearest();
}

template std::optional<Sight<double>> see_front(const TopologyWork<double>&, std::uint32_t);
template std::optional<Sight<float>> see_front(const TopologyWork<float>&, std::uint32_t);

} // namespace dsc
