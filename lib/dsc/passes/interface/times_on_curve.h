// SPDX-License-Identifier: MIT
// How far a new vertex of the interface is ahead of the time. A vertex that is ahead bends the
// curve through its neighbours: a vertex that is new on this curve is as far ahead as the curve is
// there, and not as the edge is.
#pragma once

#include "dsc/complex/gather.h"
#include "dsc/motion/interpolation.h"
#include "dsc/motion/time_ahead.h"

#include <algorithm>
#include <array>

namespace dsc {

/// The times of the vertices of a curve, from before an edge of it is split.
template <class Real>
class TimesOnCurve {
public:
    explicit TimesOnCurve(Complex<Real>& complex) : ahead_(find_times_ahead(complex)) {}

    /// Reads the times along an interface edge that leaves the centre of a star; `beyond` is the
    /// star of its end.
    void read(const Star<Real>& star, const IncidentEdges& incident, std::uint32_t incident_edge,
              const Star<Real>& beyond, const CurveNeighbours<Real>& curve) {
        times_ = {};
        if (ahead_ == nullptr || !(curve.has_first || curve.has_last)) {
            return;
        }
        const auto time_of = [&](std::uint32_t v) { return (*ahead_)[Vertex{v}].time; };
        times_[1] = time_of(star.vertex);
        times_[2] = time_of(star.link[incident_edge]);
        if (curve.has_first) {
            times_[0] = time_of(star.link[incident.other(incident_edge)]);
        }
        if (curve.has_last) {
            const IncidentEdges there = interface_edges_of(beyond);
            const bool first_is_centre = beyond.link[there.first] == star.vertex;
            times_[3] = time_of(beyond.link[first_is_centre ? there.second : there.first]);
        }
    }
    /// Notes the time of a vertex that was made at a point, if that is on the curve.
    void note(Vertex v, const CurveNeighbours<Real>& curve, const Point<Real>& point) {
        if (std::ranges::any_of(times_, [](Real time) { return time != 0; }) &&
            point == insertion_point(Insertion::cubic, curve)) {
            (*ahead_)[v].time = curve_value(curve, times_, Real(0.5));
        }
    }

private:
    VertexAttribute<TimeAhead<Real>>* ahead_; ///< null if no vertex is ever ahead
    std::array<Real, 4> times_{};
};

} // namespace dsc
