// SPDX-License-Identifier: MIT
#include "shapes/shapes.h"

#include "dsc/base/error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace dsc::scenes {

namespace {

using std::numbers::pi;
/// A larger number of vertices must result from a wrong unit.
constexpr double max_vertices = 1e8;
/// Sides shorter than this, relative to the size of the shape, are points up to rounding.
constexpr double same_point = 1e-13;

void check_positive(double value, const std::string& what, const std::string& where) {
    require(value > 0.0 && std::isfinite(value), where + ": " + what, value, "finite and above 0");
}

/// The number of edges needed for a curve of this length.
int parts(double length, double edge_length, const std::string& where) {
    check_positive(edge_length, "edge length", where);
    const double count = std::ceil(length / edge_length);
    require(count <= max_vertices, where + ": edge length too small for the shape", edge_length,
            "at most 1e8 edges");
    return std::max(1, static_cast<int>(count));
}

/// Appends the side from a to b, without b.
void append_side(const Point<double>& a, const Point<double>& b, double edge_length,
                 Outline& outline) {
    const int count = parts(std::hypot(b.x() - a.x(), b.y() - a.y()), edge_length, "polygon");
    outline.push_back(a);
    for (int i = 1; i < count; ++i) {
        outline.emplace_back(a + (static_cast<double>(i) / count) * (b - a));
    }
}

/// Appends points strictly between the ends of an arc that turns by `sweep` from `begin`.
void append_arc(const Point<double>& centre, double radius, double begin, double sweep,
                double edge_length, Outline& outline) {
    const int count = parts(radius * std::abs(sweep), edge_length, "arc");
    for (int i = 1; i < count; ++i) {
        const double angle = begin + sweep * i / count;
        outline.emplace_back(centre.x() + radius * std::cos(angle),
                             centre.y() + radius * std::sin(angle));
    }
}

double angle_of(const Point<double>& p, const Point<double>& centre) {
    return std::atan2(p.y() - centre.y(), p.x() - centre.x());
}

/// The counter-clockwise angle from `from` to `to`, in (0, 2 pi].
double turn(double from, double to) {
    const double difference = std::remainder(to - from, 2.0 * pi);
    return difference > 0.0 ? difference : difference + 2.0 * pi;
}

} // namespace

Outline circle(const Point<double>& centre, double radius, double edge_length) {
    check_positive(radius, "radius", "circle");
    const int count = std::max(fewest_of_disc, parts(2.0 * pi * radius, edge_length, "circle"));
    Outline outline;
    outline.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * pi * i / count;
        outline.emplace_back(centre.x() + radius * std::cos(angle),
                             centre.y() + radius * std::sin(angle));
    }
    return outline;
}

Outline polygon(std::span<const Point<double>> corners, double edge_length) {
    check_outline(Outline(corners.begin(), corners.end()), "polygon");
    Outline outline;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        append_side(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1], edge_length, outline);
    }
    return outline;
}

Outline rectangle(const Point<double>& low, const Point<double>& high, double edge_length) {
    check_positive(high.x() - low.x(), "width", "rectangle");
    check_positive(high.y() - low.y(), "height", "rectangle");
    const Outline corners{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    return polygon(corners, edge_length);
}

std::vector<Point<double>> slot_corners(const SlottedDisc& disc) {
    check_positive(disc.radius, "radius", "slotted_disc");
    check_positive(disc.slot_width, "slot width", "slotted_disc");
    const double half = 0.5 * disc.slot_width;
    require(half < disc.radius, "slotted_disc: slot width", disc.slot_width,
            "less than the diameter");
    const double reach = std::sqrt((disc.radius - half) * (disc.radius + half));
    const double left = disc.centre.x() - half;
    const double right = disc.centre.x() + half;
    const double bottom = disc.centre.y() - reach;
    const double top = disc.centre.y() - disc.radius + disc.slot_height;
    require(top > bottom && top < disc.centre.y() + reach, "slotted_disc: slot height",
            disc.slot_height, "such that the slot ends inside the disc");
    return {{left, bottom}, {left, top}, {right, top}, {right, bottom}};
}

Outline slotted_disc(const SlottedDisc& disc, double edge_length) {
    const std::vector<Point<double>> slot = slot_corners(disc);
    Outline outline;
    for (std::size_t i = 0; i < 3; ++i) {
        append_side(slot[i], slot[i + 1], edge_length, outline);
    }
    outline.push_back(slot[3]);
    const double begin = angle_of(slot[3], disc.centre);
    append_arc(disc.centre, disc.radius, begin, turn(begin, angle_of(slot[0], disc.centre)),
               edge_length, outline);
    return outline;
}

double slotted_disc_area(const SlottedDisc& disc) {
    const std::vector<Point<double>> slot = slot_corners(disc);
    const double half = 0.5 * disc.slot_width;
    const double above_centre = disc.slot_width * (disc.slot_height - disc.radius);
    const double below_centre = half * (disc.centre.y() - slot[0].y()) +
                                disc.radius * disc.radius * std::asin(half / disc.radius);
    return pi * disc.radius * disc.radius - above_centre - below_centre;
}

Outline crescent(const Crescent& crescent, double edge_length) {
    check_positive(crescent.radius, "radius", "crescent");
    check_positive(crescent.bite_radius, "bite radius", "crescent");
    const Point<double> axis = crescent.bite_centre - crescent.centre;
    const double distance = std::hypot(axis.x(), axis.y());
    const double r = crescent.radius;
    const double b = crescent.bite_radius;
    require(distance > std::abs(r - b) && distance < r + b,
            "crescent: distance of the bite's centre", distance, "such that the two circles cross");
    // The horns lie `along` from the centre on the axis and `across` from the axis on both sides.
    const double along = 0.5 * (distance + (r - b) * (r + b) / distance);
    const double across = std::sqrt((r - along) * (r + along));
    const Point<double> unit = axis / distance;
    const Point<double> normal{-unit.y(), unit.x()};
    const Point<double> first = crescent.centre + along * unit + across * normal;
    const Point<double> second = crescent.centre + along * unit - across * normal;

    Outline outline{first};
    const double begin = angle_of(first, crescent.centre);
    append_arc(crescent.centre, r, begin, turn(begin, angle_of(second, crescent.centre)),
               edge_length, outline);
    outline.push_back(second);
    const double back = angle_of(second, crescent.bite_centre);
    append_arc(crescent.bite_centre, b, back, -turn(angle_of(first, crescent.bite_centre), back),
               edge_length, outline);
    return outline;
}

Point<double> rounding_offset(const Dumbbell& d) {
    check_positive(d.radius, "radius", "dumbbell");
    check_positive(d.rounding, "radius of the rounding", "dumbbell");
    check_positive(d.neck, "width of the neck", "dumbbell");
    const double across = 0.5 * d.neck + d.rounding;
    const double reach = d.radius + d.rounding;
    require(across < reach, "dumbbell: width of the neck", d.neck, "less than the diameter");
    const double along = std::sqrt((reach - across) * (reach + across));
    require(0.5 * d.distance >= along, "dumbbell: distance of the centres", d.distance,
            "at least " + to_text(2 * along));
    return {along, across};
}

Outline dumbbell(const Dumbbell& d, double edge_length) {
    const Point<double> to = rounding_offset(d);
    const double angle = std::atan2(to.y(), to.x());
    const double straight = 0.5 * d.distance - to.x(); // half the length of the neck
    Outline outline;
    // One half after the other, rotated so that its disc is on the right.
    for (const double side : {1.0, -1.0}) {
        const Point<double> disc = d.centre + side * Point<double>(0.5 * d.distance, 0);
        const double turned = side > 0 ? 0.0 : pi;
        const auto at = [&](double radius, double direction) {
            return Point<double>(radius * std::cos(turned + direction),
                                 radius * std::sin(turned + direction));
        };
        const auto arc = [&](const Point<double>& centre, double radius, double begin,
                             double sweep) {
            outline.push_back(centre + at(radius, begin));
            append_arc(centre, radius, turned + begin, sweep, edge_length, outline);
        };
        const Point<double> below = disc - side * to;
        const Point<double> above = disc + side * Point<double>(-to.x(), to.y());
        arc(below, d.rounding, 0.5 * pi, angle - 0.5 * pi);
        arc(disc, d.radius, angle - pi, 2.0 * (pi - angle));
        arc(above, d.rounding, -angle, angle - 0.5 * pi);
        if (straight > same_point * d.distance) {
            append_side(above + at(d.rounding, -0.5 * pi),
                        d.centre - side * Point<double>(straight, -0.5 * d.neck), edge_length,
                        outline);
        }
    }
    return outline;
}

double dumbbell_area(const Dumbbell& d) {
    const Point<double> to = rounding_offset(d);
    const double angle = std::atan2(to.y(), to.x());
    const double discs = 2.0 * (pi - angle) * d.radius * d.radius;
    // The area between the centres of disc and arc and the axis, without the arc's sector.
    const double beside =
        0.5 * to.x() * to.y() - 0.5 * d.rounding * d.rounding * (0.5 * pi - angle);
    return discs + 4.0 * beside + d.neck * (d.distance - 2.0 * to.x());
}

Outline star(const Point<double>& centre, double outer_radius, double inner_radius, int tips,
             double edge_length) {
    check_positive(outer_radius, "outer radius", "star");
    check_positive(inner_radius, "inner radius", "star");
    require(tips >= 2, "star: number of tips", tips, "at least 2");
    Outline corners;
    for (int i = 0; i < 2 * tips; ++i) {
        const double radius = i % 2 == 0 ? outer_radius : inner_radius;
        const double angle = pi * i / tips;
        corners.emplace_back(centre.x() + radius * std::cos(angle),
                             centre.y() + radius * std::sin(angle));
    }
    return polygon(corners, edge_length);
}

} // namespace dsc::scenes
