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

/// Of the points no farther than `growth` from the discs, those that are farther than `shrinkage`
/// from the others. Where the discs have merged, arcs of that radius about the two notches take
/// away from the neck, which is 2 (sqrt(R^2 - d^2) - shrinkage) wide; d is half the distance of the
/// centres and R the radius after growth. When nothing is left of the neck, there are two pieces.
/// Empty once the shrinkage reaches R. Growth may be negative, down to minus the radius.
[[nodiscard]] ExactShape shrunk_discs(const TwoDiscs& discs, double growth, double shrinkage);

} // namespace dsc::scenes
