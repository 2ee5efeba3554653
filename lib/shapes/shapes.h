// SPDX-License-Identifier: MIT
// The shapes of the thesis's experiments (thesis, sections 9.1 to 9.7) as outlines whose edges are
// at most as long as requested. Corners become vertices with exactly the coordinates given. All
// outlines run counter-clockwise. Invalid sizes throw InputError.
#pragma once

#include "shapes/outline.h"

#include <span>
#include <vector>

namespace dsc::scenes {

/// A disc has at least this many vertices, which turn by less than 30 degrees: with fewer, growth
/// would open them as corners of a polygon.
inline constexpr int fewest_of_disc = 13;

/// max(fewest_of_disc, ceil(2 pi radius / edge_length)) vertices on the circle, the first at angle
/// zero.
[[nodiscard]] Outline circle(const Point<double>& centre, double radius, double edge_length);

/// A polygon with each side cut into equal parts.
[[nodiscard]] Outline polygon(std::span<const Point<double>> corners, double edge_length);

/// The rectangle with opposite corners `low` and `high`.
[[nodiscard]] Outline rectangle(const Point<double>& low, const Point<double>& high,
                                double edge_length);

/// Zalesak's disc (thesis, section 9.6): a disc with a slot cut from below. The values are those of
/// D. Enright, R. Fedkiw, J. Ferziger, I. Mitchell, "A hybrid particle level set method" (2002), in
/// a unit box.
struct SlottedDisc {
    Point<double> centre{0.5, 0.75};
    double radius = 0.15;
    double slot_width = 0.05;
    double slot_height = 0.25; ///< from the lowest point of the full disc to the end of the slot
};

/// The four corners of the slot in the order of the outline: lower left, upper left, upper right,
/// lower right. The lower two lie on the circle.
[[nodiscard]] std::vector<Point<double>> slot_corners(const SlottedDisc& disc);
[[nodiscard]] Outline slotted_disc(const SlottedDisc& disc, double edge_length);
/// The area in closed form, of the disc itself and not of its polygon.
[[nodiscard]] double slotted_disc_area(const SlottedDisc& disc);

/// A disc without its part in a second disc, the bite (thesis, section 9.3); the circles must
/// cross. The two horns are corners.
struct Crescent {
    Point<double> centre{0.0, 0.0};
    double radius = 1.0;
    Point<double> bite_centre{0.6, 0.0};
    double bite_radius = 0.8;
};

[[nodiscard]] Outline crescent(const Crescent& crescent, double edge_length);

/// Two discs side by side, joined by a straight neck with rounded ends: a curve without corners,
/// concave where the neck begins.
struct Dumbbell {
    Point<double> centre{0.5, 0.5};
    double radius = 0.15;   ///< of the discs
    double distance = 0.5;  ///< of their centres
    double neck = 0.06;     ///< width of the straight part
    double rounding = 0.05; ///< radius of the arcs between the neck and the discs
};

/// The vector from the centre of a disc to that of an arc beside it: x along the axis towards the
/// other disc, y away from the axis.
[[nodiscard]] Point<double> rounding_offset(const Dumbbell& dumbbell);
[[nodiscard]] Outline dumbbell(const Dumbbell& dumbbell, double edge_length);
/// The area in closed form.
[[nodiscard]] double dumbbell_area(const Dumbbell& dumbbell);

/// A star with `tips` corners on the outer circle, the first at angle zero, and as many between
/// them on the inner one.
[[nodiscard]] Outline star(const Point<double>& centre, double outer_radius, double inner_radius,
                           int tips, double edge_length);

} // namespace dsc::scenes
