// SPDX-License-Identifier: MIT
#include "topology/fronts/arrival.h"

#include "topology/fronts/front_point.h"

#include <algorithm>
#include <limits>

namespace dsc {

template <class Real>
Arrival<Real>::Arrival(const TopologyWork<Real>& work, std::span<const Triangle> part) {
    Real sum = 0;
    std::size_t known = 0;
    for (const Triangle t : part) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Corner c = corner_of(t.id, k);
            if (is_sheet(work.complex, c)) {
                fronts_.push_back(front_at(work, c));
                sum += fronts_.back().speed;
                known += fronts_.back().speed > 0 ? 1U : 0U;
            }
        }
    }
    mean_speed_ = known > 0 ? sum / static_cast<Real>(known) : Real(0);
}

template <class Real>
auto Arrival<Real>::front_at(const TopologyWork<Real>& work, Corner sheet) const -> Front {
    const Complex<Real>& complex = work.complex;
    const std::array<std::uint32_t, 2> ends{complex.vertex(next(sheet)),
                                            complex.vertex(prev(sheet))};
    const Point<Real> way = direction(complex, sheet);
    const Point<Real> normal = Point<Real>(-way.y(), way.x()).normalized(); // into the film
    const Real speed = std::max(
        dsc::speed_of(work, front_point(complex, sheet, Real(0.5)), normal).value_or(Real(0)),
        Real(0));
    return {.phase = phase_beyond(complex, sheet),
            .from = complex.position(Vertex{ends[0]}),
            .way = way,
            .is_end = {is_on_boundary(complex, Vertex{ends[0]}),
                       is_on_boundary(complex, Vertex{ends[1]})},
            .leads = {lead_of(work, ends[0], normal, speed), lead_of(work, ends[1], normal, speed)},
            .speed = speed};
}

template <class Real>
Real Arrival<Real>::way_of(Phase phase, const Point<Real>& place) const {
    Real nearest = std::numeric_limits<Real>::infinity();
    for (const Front& front : fronts_) {
        if (front.phase != phase) {
            continue;
        }
        Real share = (place - front.from).dot(front.way) / front.way.squaredNorm();
        share = front.is_end[0] ? share : std::max(share, Real(0));
        share = front.is_end[1] ? share : std::min(share, Real(1));
        const Real inside = std::clamp(share, Real(0), Real(1));
        const Real way = (front.from + share * front.way - place).norm() +
                         (1 - inside) * front.leads[0] + inside * front.leads[1];
        const Real slowness = front.speed > 0 ? mean_speed_ / front.speed : Real(1);
        nearest = std::min(nearest, slowness * way);
    }
    return nearest;
}

template class Arrival<double>;
template class Arrival<float>;

} // namespace dsc
