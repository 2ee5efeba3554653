// SPDX-License-Identifier: MIT
// Checks whether an interface is as smooth as the curve that it represents. A sawtooth shows
// neither in its area nor in its distance from the curve, but in its turning angles.
#pragma once

#include "shapes/outline.h"

#include <limits>
#include <span>

namespace dsc::scenes {

/// A vertex is jagged if it turns by more than twice the exact curve's turn plus 2 degrees.
struct Jaggedness {
    /// The largest excess of a turn over the allowed one: 0 or less if no vertex is jagged, minus
    /// infinity without vertices.
    double largest_excess_deg = -std::numeric_limits<double>::infinity();
    Point<double> worst{0.0, 0.0}; ///< the vertex of the largest excess
};

/// Compares the turn at each vertex of `polygons` with that of the exact outlines over the same
/// stretch. Both must have the region on their left. O((n + m) log m) for n vertices near m exact
/// ones. No vertex is examined if either set is empty. Throws InputError for an outline with fewer
/// than three points, or with a point that is not finite.
[[nodiscard]] Jaggedness measure_jaggedness(std::span<const Outline> polygons,
                                            std::span<const Outline> exact);

} // namespace dsc::scenes
