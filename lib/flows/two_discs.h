// SPDX-License-Identifier: MIT
// Two discs that grow along their normals, merge, and shrink again: the exact shapes, in arcs of
// circles.
#pragma once

#include "shapes/outline.h"

namespace dsc::scenes {

/// Two discs of one radius. They must not coincide.
struct TwoDiscs {
    Point<double> first{0.375, 0.5};
    Point<double> second{0.625, 0.5};
    double radius = 0.1;
};

/// The points no farther than `growth` from the discs: their union, of a larger radius. Throws
/// InputError unless `growth` is finite and the radius afterwards positive.
[[nodiscard]] ExactShape grown_discs(const TwoDiscs& discs, double growth);

/// The points of that union that are farther than `shrinkage` from its complement. Where the discs
/// have merged, arcs of that radius about the two notches take away from the neck, which is
/// 2 (sqrt(R^2 - d^2) - shrinkage) wide; d is half the distance of the centres and R the radius
/// after growth. When nothing is left of the neck, there are two pieces. Empty once the shrinkage
/// reaches R. Throws InputError for a shrinkage that is negative or not finite.
[[nodiscard]] ExactShape shrunk_discs(const TwoDiscs& discs, double growth, double shrinkage);

/// The width of the neck: see `shrunk_discs`. Negative, or NaN, where there is none.
[[nodiscard]] double neck_width(const TwoDiscs& discs, double growth, double shrinkage);

} // namespace dsc::scenes
