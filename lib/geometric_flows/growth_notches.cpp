// SPDX-License-Identifier: MIT
#include "geometric_flows/growth_notches.h"

#include <algorithm>
#include <cmath>

namespace dsc {

namespace {

constexpr double bulge = 0.2; // largest change of the curve if a vertex is removed, in edge lengths

// The distance that a notch moves along its sheets in this sub-step, limited by the largest
// move.
template <class Real>
Real reach_of(const GrowthFronts<Real>& fronts, const GrowthBend<Real>& notch) {
    const Real half = std::abs(notch.turn) / 2;
    const Real max = fronts.lengths(fronts.work.options.sub_step) * std::cos(half);
    return (std::min(fronts.way(notch.speed), max) + fronts.lengths(GrowthFronts<Real>::margin)) *
           std::tan(half);
}

// Whether the vertex blocked a notch at the end of this edge and has been removed. Also true if
// only another submesh can decide this.
template <class Real>
bool remove_beside(GrowthFronts<Real>& fronts, const Star<Real>& star, const GrowthBend<Real>& bend,
                   std::uint32_t incident_edge, std::uint32_t other) {
    const std::uint32_t u = star.link[incident_edge];
    const Point<Real> notch = link_point(star, incident_edge);
    const Point<Real> beyond = link_point(star, other);
    const Real distance = (notch - bend.at).norm();
    if (!fronts.is_feature(u) || fronts.is_in_fan(u) ||
        distance > fronts.lengths(fronts.work.options.sub_step + 4 * GrowthFronts<Real>::margin)) {
        return false;
    }
    Star<Real>& next_star = fronts.work.other_star;
    const bool gathered = gather(fronts.complex, fronts.work.submesh.region, u, next_star);
    if (!next_star.owned) {
        fronts.work.deferred.remeshing(star.vertex);
        return true;
    }
    const GrowthBend<Real> there = gathered ? fronts.bend_of(next_star) : GrowthBend<Real>{};
    if (!there.known || there.turn * there.speed >= 0 ||
        std::abs(there.turn) < fronts.smooth_angle) {
        return false;
    }
    const Point<Real> chord = beyond - notch;
    const Real off = std::abs(cross<Real>(chord, bend.at - notch)) / chord.norm();
    if (distance > reach_of(fronts, there) + fronts.lengths(GrowthFronts<Real>::margin) ||
        off > fronts.lengths(bulge) || !turns_less<Real>(beyond, bend.at, notch, Real(0))) {
        return false;
    }
    return fronts.collapse_into(star, incident_edge) || fronts.collapse_into(star, other);
}

} // namespace

template <class Real>
void mark_notch(GrowthFronts<Real>& fronts, std::uint32_t v, const GrowthBend<Real>& bend) {
    if (std::abs(bend.turn) < fronts.smooth_angle) {
        fronts.complex.set_feature(Vertex{v}, false);
    } else if (bend.turn * bend.speed < 0 && std::abs(bend.turn) > fronts.notch_angle &&
               fronts.has_room(bend)) {
        fronts.complex.set_feature(Vertex{v}, true);
    }
}

template <class Real>
bool remove_before_notch(GrowthFronts<Real>& fronts, const Star<Real>& star,
                         const GrowthBend<Real>& bend) {
    return remove_beside(fronts, star, bend, bend.in, bend.out) ||
           remove_beside(fronts, star, bend, bend.out, bend.in);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void mark_notch(GrowthFronts<Real>&, std::uint32_t, const GrowthBend<Real>&);         \
    template bool remove_before_notch(GrowthFronts<Real>&, const Star<Real>&,                      \
                                      const GrowthBend<Real>&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
