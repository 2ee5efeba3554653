// SPDX-License-Identifier: MIT
// The interface as a curve, seen from the star of one of its vertices: its smooth continuation, its
// bend, and the distance to the next sheet.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"
#include "dsc/geometry/points.h"
#include "dsc/motion/interpolation.h"

#include <algorithm>

namespace dsc {

/// Whether a cubic may pass through `at`: it must not be a feature, nor turn by a right angle or
/// more, which a polynomial in chord length cannot follow.
template <class Real>
bool is_smooth(const Complex<Real>& complex, std::uint32_t vertex, const Point<Real>& from,
               const Point<Real>& at, const Point<Real>& to) {
    return !complex.is_feature(Vertex{vertex}) && turns_less<Real>(from, at, to, Real(0));
}

/// Sets p0, p1, p2 and has_first, for the interface edge that leaves the centre along
/// `incident_edge`. On the domain boundary the curve ends.
template <class Real>
void see_from_centre(const Complex<Real>& complex, const Star<Real>& star,
                     const IncidentEdges& incident, std::uint32_t incident_edge,
                     CurveNeighbours<Real>& curve) {
    curve.p1 = {star.x0, star.y0};
    curve.p2 = link_point(star, incident_edge);
    curve.has_first = false;
    if (incident.count == 2 && star.closed) {
        curve.p0 = link_point(star, incident.other(incident_edge));
        curve.has_first = is_smooth<Real>(complex, star.vertex, curve.p0, curve.p1, curve.p2);
    }
}

/// Sets p3 and has_last, from the star of the vertex at p2; `from` is the vertex at p1.
template <class Real>
void see_from_beyond(const Complex<Real>& complex, const Star<Real>& beyond, std::uint32_t from,
                     CurveNeighbours<Real>& curve) {
    const IncidentEdges incident = interface_edges_of(beyond);
    curve.has_last = false;
    if (incident.count == 2 && beyond.closed) {
        const bool first_is_from = beyond.link[incident.first] == from;
        curve.p3 = link_point(beyond, first_is_from ? incident.second : incident.first);
        curve.has_last = is_smooth<Real>(complex, beyond.vertex, curve.p1, curve.p2, curve.p3);
    }
}

/// Squared distance from the centre to interface edges of its link: the next sheet of the
/// interface, if it is no farther away than one triangle. Edges that continue the centre's own are
/// not another sheet. Infinity if there is none. O(degree).
template <class Real>
Real squared_gap(const Complex<Real>& complex, const Star<Real>& star,
                 const IncidentEdges& incident) {
    Real gap = std::numeric_limits<Real>::infinity();
    const auto is_own = [&](std::uint32_t i) {
        return incident.count > 0 &&
               (i == incident.first || (incident.count > 1 && i == incident.second));
    };
    for (std::uint32_t i = 0; i < star.size; ++i) {
        const std::uint32_t next_link = star.closed && i + 1 == star.size ? 0 : i + 1;
        if (is_own(i) || is_own(next_link)) {
            continue;
        }
        const Phase across = complex.phase_at(complex.twin(star.corner[i]));
        if (across != star.phase[i] && across != border_phase) {
            gap = std::min(gap, squared_distance<Real>({star.x0, star.y0}, link_point(star, i),
                                                       link_point(star, next_link)));
        }
    }
    return gap;
}

} // namespace dsc
