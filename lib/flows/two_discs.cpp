// SPDX-License-Identifier: MIT
#include "flows/two_discs.h"

#include "flows/arcs.h"

#include <cmath>
#include <numbers>

namespace dsc::scenes {

ExactShape shrunk_discs(const TwoDiscs& discs, double growth, double shrinkage) {
    using std::numbers::pi;
    const double grown = discs.radius + growth;
    const Point<double> way = discs.second - discs.first;
    const double d = way.norm() / 2;
    // The centres are at -d and d on its x axis.
    const LocalFrame frame{(discs.first + discs.second) / 2, way / (2 * d)};
    ExactShape shape;
    const double radius = grown - shrinkage;
    if (radius <= 0) {
        return shape;
    }
    const Point<double> left(-d, 0);
    const Point<double> right(d, 0);
    if (grown <= d) {
        append_arcs(frame, {{left, radius, 0, 2 * pi}}, shape);
        append_arcs(frame, {{right, radius, 0, 2 * pi}}, shape);
        return shape;
    }
    // The notches lie above and below the middle, at the angle phi from the centres.
    const double height = std::sqrt(grown * grown - d * d);
    const double phi = std::atan2(height, d);
    const Point<double> above(0, height);
    const Point<double> below(0, -height);
    const Arc about_left{left, radius, phi, 2 * pi - phi};
    const Arc about_right{right, radius, phi - pi, pi - phi};
    if (shrinkage < height) {
        // Clockwise about the notches, which lie outside.
        append_arcs(frame,
                    {about_left,
                     {below, shrinkage, pi - phi, phi},
                     about_right,
                     {above, shrinkage, -phi, phi - pi}},
                    shape);
        return shape;
    }
    // The arcs about the notches cross on the axis: two pieces, each with a tip there.
    const double tip = std::asin(height / shrinkage);
    append_arcs(frame,
                {about_left,
                 {below, shrinkage, pi - phi, pi - tip},
                 {above, shrinkage, pi + tip, pi + phi}},
                shape);
    append_arcs(frame, {about_right, {above, shrinkage, -phi, -tip}, {below, shrinkage, tip, phi}},
                shape);
    return shape;
}

} // namespace dsc::scenes
