// SPDX-License-Identifier: MIT
// A dumbbell that shrinks along its normals: the exact shapes by the principle of Huygens, in arcs
// of circles and straight sides.
#pragma once

#include "shapes/outline.h"
#include "shapes/shapes.h"

namespace dsc::scenes {

/// The points that are farther than `depth` from the complement. Discs lose that much of their
/// radius and roundings, whose centres lie outside, gain it. At half the width of the neck its
/// whole straight length closes at once: from then on there are two lobes, each bounded by an arc
/// of its disc and two of roundings, which meet on the axis in a tip. Empty once `depth` reaches
/// the radius of the discs. Throws InputError for an invalid dumbbell.
[[nodiscard]] ExactShape eroded_dumbbell(const Dumbbell& dumbbell, double depth);

} // namespace dsc::scenes
