// SPDX-License-Identifier: MIT
// The exact shapes of two discs that grow along their normals, merge, and shrink again: circular
// arcs.
#pragma once

#include "shapes/outline.h"

namespace dsc::scenes {

/// Two discs of one radius. They must not coincide.
struct TwoDiscs {
    Point<double> first{0.375, 0.5};
    Point<double> second{0.625, 0.5};
    double radius = 0.1;
};

/// The discs grown by `growth` and then eroded by `shrinkage`: the points of the grown shape that
/// are farther than `shrinkage` from its complement. If the discs have merged, arcs of radius
/// `shrinkage` about the two notches bound the neck, whose width is 2 (sqrt(R^2 - d^2) -
/// shrinkage); d is half the distance of the centres and R the radius after growth. At a width of 0
/// the shape splits into two pieces. It is empty once `shrinkage` reaches R. `growth` may be
/// negative, down to minus the radius.
[[nodiscard]] ExactShape shrunk_discs(const TwoDiscs& discs, double growth, double shrinkage);

} // namespace dsc::scenes
