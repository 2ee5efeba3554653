// SPDX-License-Identifier: MIT
// Whether an interface is as smooth as the curve that it represents. Neither its area nor its
// distance from that curve reveals a sawtooth edge; its turning angles do.
#pragma once

#include "shapes/outline.h"

#include <limits>
#include <span>

namespace dsc::scenes {

/// A vertex is jagged if it turns by more than twice the exact curve's turn plus 2 degrees.
struct Jaggedness {
    /// The largest excess of a turn over what is allowed; not above 0 if no vertex is jagged, minus
    /// infinity if there are no vertices.
    double largest_excess_deg = -std::numeric_limits<double>::infinity();
    Point<double> worst{0.0, 0.0}; ///< the vertex of the largest excess
};

/// Compares the turn at each vertex of `polygons` with that of the exact outlines over the same
/// stretch. Both have the region on their left. O((n + m) log m) for n vertices near to m exact
/// ones. No vertex is examined if either set is empty. Throws InputError for an outline with fewer
/// than three points, or with a point that is not finite.
[[nodiscard]] Jaggedness measure_jaggedness(std::span<const Outline> polygons,
                                            std::span<const Outline> exact);

} // namespace dsc::scenes
