// SPDX-License-Identifier: MIT
#include "topology/fronts/encounter.h"

#include "topology/fronts/front_curve.h"
#include "topology/fronts/front_point.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

/// Fronts approach each other if they come closer by this share of their ways: their normals differ
/// by more than 53 degrees then if they are equally fast.
constexpr double min_rate_of_approach = 0.2;
/// A vertex that meets the other front within this of the end of the seam, in edge lengths, would
/// make an edge of the seam that is too short to be kept.
constexpr double reach_of_end = 0.2;

template <class Real>
class PassedEnd {
public:
    PassedEnd(const TopologyWork<Real>& work, const Sectors<Real>& sectors, std::uint32_t v,
              std::size_t k)
        : work_(work), complex_(work.complex), v_(v), sector_(sectors[k]),
          own_(sectors.after(k).phase) {}

    [[nodiscard]] std::optional<Sight<Real>> nearer() const {
        const auto first = at_end(true);
        const auto last = at_end(false);
        return first && (!last || first->gap <= last->gap) ? first : last;
    }

private:
    [[nodiscard]] Point<Real> at(std::uint32_t v) const { return complex_.position(Vertex{v}); }

    // Beyond the first or the last edge of the sector.
    [[nodiscard]] std::optional<Sight<Real>> at_end(bool is_first) const {
        const std::uint32_t q = is_first ? complex_.vertex(next(sector_.first))
                                         : complex_.vertex(prev(last_of(complex_, sector_)));
        if (!is_junction(complex_, Vertex{q}) || complex_.is_locked(Vertex{q})) {
            return {};
        }
        Sectors<Real> there;
        find_sectors(complex_, Vertex{q}, there);
        if (there.is_on_boundary) {
            return {};
        }
        for (const Sector<Real>& film : there.list) {
            const Corner last = last_of(complex_, film);
            if (film.phase != sector_.phase ||
                complex_.vertex(is_first ? prev(last) : next(film.first)) != v_) {
                continue;
            }
            const Corner edge = is_first ? prev(film.first) : next(last); // of the other front
            Sight<Real> sight{.v = v_, .q = q, .film = film.phase, .is_passed = true};
            sight.gap = (at(q) - at(v_)).norm();
            sight.one = own_;
            sight.other = phase_beyond(complex_, edge);
            if (contact_of(work_, sight) > 0 && see(sight, edge)) {
                const auto met = encounter_of(sight, at(v_));
                const Real reach = static_cast<Real>(reach_of_end) * work_.edge_length;
                if (met && (met->place - at(q)).dot(middle_of(film)) <= reach) {
                    return sight;
                }
            }
        }
        return {};
    }

    // Notes the fronts; returns whether their speeds are known.
    [[nodiscard]] bool see(Sight<Real>& sight, Corner edge) const {
        sight.normal_v = normal_now(work_, v_, sector_);
        const auto speed = speed_of(work_, front_point<Real>(v_), sight.normal_v);
        if (!speed) {
            return false;
        }
        const Real middle = Real(0.5);
        const CurvePoint<Real> front = curve_now(work_, edge, middle, *speed);
        sight.front_q = front.place;
        sight.normal_q = front.normal;
        sight.speed_v = *speed;
        sight.speed_q =
            speed_of(work_, front_point(complex_, edge, middle), front.normal).value_or(*speed);
        sight.lead_v = lead_of(work_, v_, sight.normal_v, *speed);
        return true;
    }

    const TopologyWork<Real>& work_;
    const Complex<Real>& complex_;
    std::uint32_t v_;
    const Sector<Real>& sector_;
    Phase own_;
};

} // namespace

template <class Real>
Real contact_of(const TopologyWork<Real>& work, const Sight<Real>& sight) {
    if (sight.one == sight.other || !meet_in_points(sight.film)) {
        return 0;
    }
    return within_triangles(work, std::min(contact_of(work, sight.film, sight.one),
                                           contact_of(work, sight.film, sight.other)));
}

template <class Real>
std::optional<Encounter<Real>> encounter_of(const Sight<Real>& sight, const Point<Real>& v) {
    const Real cosine = sight.normal_v.dot(sight.normal_q);
    const Real rate = sight.speed_q - sight.speed_v * cosine;
    if (!(rate > static_cast<Real>(min_rate_of_approach) *
                     (std::abs(sight.speed_v) + std::abs(sight.speed_q)))) {
        return {};
    }
    const Real gap = (v - sight.front_q).dot(sight.normal_q) + sight.lead_q;
    const Real shares = (gap - sight.lead_v * cosine) / rate;
    return Encounter<Real>{.place = v + (shares * sight.speed_v - sight.lead_v) * sight.normal_v,
                           .shares = shares};
}

template <class Real>
std::optional<Sight<Real>> see_passed_end(const TopologyWork<Real>& work,
                                          const Sectors<Real>& sectors, std::uint32_t v,
                                          std::size_t k) {
    return PassedEnd<Real>(work, sectors, v, k).nearer();
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Real contact_of(const TopologyWork<Real>&, const Sight<Real>&);                       \
    template std::optional<Encounter<Real>> encounter_of(const Sight<Real>&, const Point<Real>&);  \
    template std::optional<Sight<Real>> see_passed_end(                                            \
        const TopologyWork<Real>&, const Sectors<Real>&, std::uint32_t, std::size_t);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
