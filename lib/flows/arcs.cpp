// SPDX-License-Identifier: MIT
#include "flows/arcs.h"

#include <algorithm>
#include <cmath>

namespace dsc::scenes {

namespace {

constexpr int chords_of_arc = 1 << 13;
/// Ends nearer than this, relative to coordinates and radii, coincide up to rounding.
constexpr double same_point = 1e-13;

Point<double> point_on(const Arc& arc, double angle) {
    return arc.centre + arc.radius * Point<double>(std::cos(angle), std::sin(angle));
}

/// The arc's contribution to the area: half the integral of x dy - y dx.
double area_of(const Arc& arc) {
    return arc.radius / 2 *
           (arc.radius * (arc.end - arc.begin) +
            arc.centre.x() * (std::sin(arc.end) - std::sin(arc.begin)) -
            arc.centre.y() * (std::cos(arc.end) - std::cos(arc.begin)));
}

Point<double> out_of(const LocalFrame& frame, const Point<double>& p) {
    return frame.origin + p.x() * frame.axis +
           p.y() * Point<double>(-frame.axis.y(), frame.axis.x());
}

} // namespace

void append_arcs(const LocalFrame& frame, const std::vector<Arc>& arcs, ExactShape& shape) {
    Outline outline;
    for (std::size_t k = 0; k < arcs.size(); ++k) {
        const Arc& arc = arcs[k];
        const Arc& following = arcs[k + 1 < arcs.size() ? k + 1 : 0];
        for (int i = 0; i < chords_of_arc && arc.radius > 0; ++i) {
            const double share = static_cast<double>(i) / chords_of_arc;
            outline.push_back(
                out_of(frame, point_on(arc, arc.begin + share * (arc.end - arc.begin))));
        }
        shape.area += area_of(arc);
        const Point<double> from = point_on(arc, arc.end);
        const Point<double> to = point_on(following, following.begin);
        const double size =
            std::max(arc.centre.norm(), following.centre.norm()) + arc.radius + following.radius;
        if ((from - to).norm() > same_point * size) {
            outline.push_back(out_of(frame, from));
            shape.area += (from.x() * to.y() - from.y() * to.x()) / 2;
        }
        // The area between chords and arc, with the height of each segment at its middle.
        const double step = std::abs(arc.end - arc.begin) / chords_of_arc;
        shape.own_error += chords_of_arc * std::pow(arc.radius, 2) * std::pow(step, 3) / 12;
    }
    shape.outlines.push_back(std::move(outline));
}

} // namespace dsc::scenes
