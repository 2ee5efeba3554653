// SPDX-License-Identifier: MIT
#include "flows/eroded_dumbbell.h"

#include "flows/arcs.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace dsc::scenes {

ExactShape eroded_dumbbell(const Dumbbell& d, double depth) {
    using std::numbers::pi;
    const Point<double> offset = rounding_offset(d);
    ExactShape shape;
    if (depth >= d.radius) {
        return shape;
    }
    // The right half, relative to the origin: the centres of its disc and its roundings, and the
    // angle between the axis and the direction from the disc's centre to a rounding's centre.
    const Point<double> disc(d.distance / 2, 0);
    const Point<double> above(disc.x() - offset.x(), offset.y());
    const Point<double> below(above.x(), -above.y());
    const double angle = std::atan2(offset.y(), offset.x());
    const double radius = d.radius - depth;
    const double rounding = d.rounding + depth;
    const bool is_whole = depth < d.neck / 2;
    // Half of the angle between the two sheets of a lobe's tip.
    const double tip = is_whole ? 0 : std::acos((d.neck / 2 + d.rounding) / rounding);
    std::vector<Arc> right{{below, rounding, pi / 2 - tip, angle},
                           {disc, radius, angle - pi, pi - angle},
                           {above, rounding, -angle, tip - pi / 2}};
    std::vector<Arc> left; // the same curve, rotated by 180 degrees
    for (const Arc& arc : right) {
        left.push_back({-arc.centre, arc.radius, arc.begin + pi, arc.end + pi});
    }
    if (is_whole) { // one curve, with a neck of two straight sides
        right.insert(right.end(), left.begin(), left.end());
        append_arcs({.origin = d.centre}, right, shape);
    } else {
        append_arcs({.origin = d.centre}, right, shape);
        append_arcs({.origin = d.centre}, left, shape);
    }
    return shape;
}

} // namespace dsc::scenes
