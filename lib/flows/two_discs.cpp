// SPDX-License-Identifier: MIT
#include "flows/two_discs.h"

#include "dsc/base/error.h"
#include "flows/arcs.h"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace dsc::scenes {

namespace {

using std::numbers::pi;

/// The two discs in a frame in which their centres are at -d and d on the x axis.
struct Frame {
    explicit Frame(const TwoDiscs& discs)
        : middle((discs.first + discs.second) / 2), axis(discs.second - discs.first),
          half(axis.norm() / 2) {
        require(half > 0 && std::isfinite(half), "distance of the centres", 2 * half,
                "a positive finite length");
        axis /= 2 * half;
    }

    Point<double> middle;
    Point<double> axis;
    double half;
};

void append(const Frame& frame, std::initializer_list<Arc> arcs, ExactShape& shape) {
    append_arcs({frame.middle, frame.axis}, arcs, shape);
}

} // namespace

ExactShape shrunk_discs(const TwoDiscs& discs, double growth, double shrinkage) {
    const double grown = discs.radius + growth;
    require(std::isfinite(growth) && std::isfinite(grown) && grown > 0, "growth", growth,
            "a finite length, and more than minus the radius");
    require(std::isfinite(shrinkage) && shrinkage >= 0, "shrinkage", shrinkage,
            "a finite length of 0 or more");
    const Frame frame(discs);
    ExactShape shape;
    shape.description = "two discs in closed form, grown by " + std::to_string(growth) +
                        " and shrunk by " + std::to_string(shrinkage);
    const double radius = grown - shrinkage;
    if (radius <= 0) {
        return shape;
    }
    const double d = frame.half;
    const Point<double> left(-d, 0);
    const Point<double> right(d, 0);
    if (grown <= d) {
        append(frame, {{left, radius, 0, 2 * pi}}, shape);
        append(frame, {{right, radius, 0, 2 * pi}}, shape);
        return shape;
    }
    // The notches lie above and below the middle, at the angle phi as seen from the centres.
    const double height = std::sqrt(grown * grown - d * d);
    const double phi = std::atan2(height, d);
    const Point<double> above(0, height);
    const Point<double> below(0, -height);
    const Arc about_left{left, radius, phi, 2 * pi - phi};
    const Arc about_right{right, radius, phi - pi, pi - phi};
    if (shrinkage < height) {
        // Clockwise about the notches, which lie outside.
        append(frame,
               {about_left,
                {below, shrinkage, pi - phi, phi},
                about_right,
                {above, shrinkage, -phi, phi - pi}},
               shape);
        return shape;
    }
    // The arcs about the notches cross on the axis: two pieces, each with a tip there.
    const double tip = std::asin(height / shrinkage);
    append(frame,
           {about_left,
            {below, shrinkage, pi - phi, pi - tip},
            {above, shrinkage, pi + tip, pi + phi}},
           shape);
    append(frame, {about_right, {above, shrinkage, -phi, -tip}, {below, shrinkage, tip, phi}},
           shape);
    return shape;
}

} // namespace dsc::scenes
