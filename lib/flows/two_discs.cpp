// SPDX-License-Identifier: MIT
#include "flows/two_discs.h"

#include "dsc/base/require.h"

#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int chords_of_arc = 1 << 13;

/// Counter-clockwise where `end` is larger than `begin`.
struct Arc {
    Point<double> centre;
    double radius;
    double begin; ///< radians
    double end;
};

Point<double> point_on(const Arc& arc, double angle) {
    return arc.centre + arc.radius * Point<double>(std::cos(angle), std::sin(angle));
}

/// What the arc contributes to the area: half the integral of x dy - y dx.
double area_of(const Arc& arc) {
    return arc.radius / 2 *
           (arc.radius * (arc.end - arc.begin) +
            arc.centre.x() * (std::sin(arc.end) - std::sin(arc.begin)) -
            arc.centre.y() * (std::cos(arc.end) - std::cos(arc.begin)));
}

/// The two discs in a frame in which their centres are at -d and d on the x axis.
struct Frame {
    explicit Frame(const TwoDiscs& discs)
        : middle((discs.first + discs.second) / 2), axis(discs.second - discs.first),
          half(axis.norm() / 2) {
        require(half > 0 && std::isfinite(half), "distance of the centres", 2 * half,
                "a positive finite length");
        axis /= 2 * half;
    }
    [[nodiscard]] Point<double> out_of(const Point<double>& p) const {
        return middle + p.x() * axis + p.y() * Point<double>(-axis.y(), axis.x());
    }

    Point<double> middle;
    Point<double> axis;
    double half;
};

/// A closed curve of arcs, each of which begins where the one before it ends.
void append(const Frame& frame, const std::vector<Arc>& arcs, ExactShape& shape) {
    Outline outline;
    for (const Arc& arc : arcs) {
        for (int i = 0; i < chords_of_arc && arc.radius > 0; ++i) {
            const double share = static_cast<double>(i) / chords_of_arc;
            outline.push_back(
                frame.out_of(point_on(arc, arc.begin + share * (arc.end - arc.begin))));
        }
        shape.area += area_of(arc);
        // Segments between chords and arc, with the height of each at its middle.
        const double step = std::abs(arc.end - arc.begin) / chords_of_arc;
        shape.own_error += chords_of_arc * std::pow(arc.radius, 2) * std::pow(step, 3) / 12;
    }
    shape.outlines.push_back(std::move(outline));
}

double radius_after(const TwoDiscs& discs, double growth) {
    const double radius = discs.radius + growth;
    require(std::isfinite(growth) && std::isfinite(radius) && radius > 0, "growth", growth,
            "a finite length, and more than minus the radius");
    return radius;
}

} // namespace

ExactShape grown_discs(const TwoDiscs& discs, double growth) {
    return shrunk_discs(discs, growth, 0);
}

ExactShape shrunk_discs(const TwoDiscs& discs, double growth, double shrinkage) {
    const double grown = radius_after(discs, growth);
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

double neck_width(const TwoDiscs& discs, double growth, double shrinkage) {
    const double grown = radius_after(discs, growth);
    const double d = Frame(discs).half;
    return 2 * (std::sqrt(grown * grown - d * d) - shrinkage);
}

} // namespace dsc::scenes
