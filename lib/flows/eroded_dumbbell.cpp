// SPDX-License-Identifier: MIT
#include "flows/eroded_dumbbell.h"

#include "dsc/base/error.h"
#include "flows/arcs.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace dsc::scenes {

namespace {

using std::numbers::pi;

/// The right half of a dumbbell about the origin, before it moves.
struct Half {
    explicit Half(const Dumbbell& d)
        : offset(rounding_offset(d)), disc(d.distance / 2, 0),
          above(disc.x() - offset.x(), offset.y()), below(above.x(), -above.y()),
          angle(std::atan2(offset.y(), offset.x())) {}

    Point<double> offset;
    Point<double> disc;  ///< the centres: of the disc
    Point<double> above; ///< of the rounding above the neck
    Point<double> below;
    double angle; ///< from the axis to a rounding's centre, seen from the disc's
};

/// The half on the other side: turned by half a circle.
Arc turned(const Arc& arc) { return {-arc.centre, arc.radius, arc.begin + pi, arc.end + pi}; }

void append_both(const Point<double>& centre, std::span<const Arc> right, ExactShape& shape) {
    std::vector<Arc> arcs(right.begin(), right.end());
    for (const Arc& arc : right) {
        arcs.push_back(turned(arc));
    }
    append_arcs({.origin = centre}, arcs, shape);
}

/// Appends the outline as one curve: from the neck below along the right half to the neck above,
/// and then along the left half.
void append_in_one_piece(const Dumbbell& d, double depth, ExactShape& shape) {
    const Half half(d);
    const double rounding = d.rounding + depth;
    append_both(d.centre,
                std::array{Arc{half.below, rounding, pi / 2, half.angle},
                           Arc{half.disc, d.radius - depth, half.angle - pi, pi - half.angle},
                           Arc{half.above, rounding, -half.angle, -pi / 2}},
                shape);
}

void append_lobes(const Dumbbell& d, double depth, ExactShape& shape) {
    const Half half(d);
    const double radius = d.radius - depth;
    const double rounding = d.rounding + depth;
    // Half of the angle between its two sheets.
    const double tip = std::acos((d.neck / 2 + d.rounding) / rounding);
    const std::array lobe{Arc{half.below, rounding, pi / 2 - tip, half.angle},
                          Arc{half.disc, radius, half.angle - pi, pi - half.angle},
                          Arc{half.above, rounding, -half.angle, tip - pi / 2}};
    append_arcs({.origin = d.centre}, lobe, shape);
    append_arcs({.origin = d.centre}, std::array{turned(lobe[0]), turned(lobe[1]), turned(lobe[2])},
                shape);
}

} // namespace

ExactShape eroded_dumbbell(const Dumbbell& d, double depth) {
    require(std::isfinite(depth) && depth >= 0, "depth", depth, "a finite length of 0 or more");
    ExactShape shape;
    shape.description = "a dumbbell in closed form, eroded by " + std::to_string(depth);
    (void)rounding_offset(d); // throws for an invalid dumbbell
    if (depth >= d.radius) {
        return shape;
    }
    if (depth < d.neck / 2) {
        append_in_one_piece(d, depth, shape);
    } else {
        append_lobes(d, depth, shape);
    }
    return shape;
}

} // namespace dsc::scenes
