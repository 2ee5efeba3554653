// SPDX-License-Identifier: MIT
// A growing interface seen from one of its vertices: its turn, and the direction in which it moves.
#pragma once

#include "dsc/complex/gather.h"
#include "dsc/geometry/points.h"
#include "geometric_flows/growth.h"

namespace dsc {

/// The curve at a vertex with two interface edges; the larger phase is on the left.
template <class Real>
struct GrowthBend {
    std::uint32_t in = no_id;  ///< incident edge to the previous vertex
    std::uint32_t out = no_id; ///< incident edge to the next one
    Point<Real> from = Point<Real>::Zero();
    Point<Real> at = Point<Real>::Zero();
    Point<Real> to = Point<Real>::Zero();
    Real turn = 0;      ///< in radians, positive to the left
    Real speed = 0;     ///< to the right
    bool known = false; ///< false at junctions, and on the domain boundary
};

/// The bend at the centre of a star. O(degree).
template <class Real>
[[nodiscard]] GrowthBend<Real> bend_of(const Star<Real>& star, const GrowthOptions<Real>& options,
                                       Real time) {
    GrowthBend<Real> bend;
    const IncidentEdges incident = interface_edges_of(star);
    if (incident.count != 2 || !star.closed) {
        return bend;
    }
    const bool first_is_out = star.phase_after(incident.first) > star.phase_before(incident.first);
    bend.out = first_is_out ? incident.first : incident.second;
    bend.in = incident.other(bend.out);
    bend.from = link_point(star, bend.in);
    bend.at = {star.x0, star.y0};
    bend.to = link_point(star, bend.out);
    bend.turn = turn_angle<Real>(bend.from, bend.at, bend.to);
    bend.speed = growth_speed(options, star.phase_after(bend.out), star.phase_before(bend.out),
                              bend.at, time);
    bend.known = true;
    return bend;
}

/// Whether both edges are longer than that. Shorter ones may turn sharply for a while, until
/// remeshing has removed them: such a turn is no feature.
template <class Real>
[[nodiscard]] bool has_longer_edges(const GrowthBend<Real>& bend, Real length) {
    return (bend.from - bend.at).squaredNorm() > length * length &&
           (bend.to - bend.at).squaredNorm() > length * length;
}

/// Counter-clockwise by an angle in radians.
template <class Real>
[[nodiscard]] Point<Real> turned(const Point<Real>& direction, Real by) {
    const Real cosine = std::cos(by);
    const Real sine = std::sin(by);
    return {cosine * direction.x() - sine * direction.y(),
            sine * direction.x() + cosine * direction.y()};
}

/// The distance that the vertex of a ray has moved along it: positive if the left phase has grown.
template <class Real>
[[nodiscard]] Real along(const FanRay<Real>& ray, const Point<Real>& at) {
    const Real reached = (at - ray.source).dot(ray.direction);
    return ray.state == FanState::opening ? reached - static_cast<Real>(ray.start) : reached;
}

} // namespace dsc
