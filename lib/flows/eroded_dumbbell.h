// SPDX-License-Identifier: MIT
// The exact shapes of a dumbbell that shrinks along its normals, by Huygens' principle: circular
// arcs and straight sides.
#pragma once

#include "shapes/outline.h"
#include "shapes/shapes.h"

namespace dsc::scenes {

/// The points that are farther than `depth` from the complement. The radius of the discs falls by
/// `depth`, and that of the roundings, whose centres lie outside, grows by it. When `depth` is half
/// the width of the neck, the straight part of the neck closes at once; then there are two lobes,
/// each bounded by an arc of its disc and two arcs of roundings, which meet on the axis in a tip.
/// The shape is empty once `depth` reaches the radius of the discs. Throws InputError for an
/// invalid dumbbell.
[[nodiscard]] ExactShape eroded_dumbbell(const Dumbbell& dumbbell, double depth);

} // namespace dsc::scenes
