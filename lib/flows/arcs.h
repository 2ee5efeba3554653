// SPDX-License-Identifier: MIT
// Closed curves of circular arcs and straight sides: exact shapes whose area has a closed form.
#pragma once

#include "shapes/outline.h"

#include <vector>

namespace dsc::scenes {

/// Counter-clockwise about its centre where `end` is larger than `begin`, else clockwise.
struct Arc {
    Point<double> centre;
    double radius; ///< 0: a point
    double begin;  ///< radians
    double end;
};

/// Coordinates in which a shape is simple to write down.
struct LocalFrame {
    Point<double> origin{0, 0};
    Point<double> axis{1, 0}; ///< of x, a unit vector
};

/// Appends the closed curve that runs along the arcs in their order: an outline with its vertices
/// on the arcs, its area, and the area between the two to `own_error`. A straight side leads from
/// an arc to the next one unless that begins where the first one ends. Outlines run
/// counter-clockwise about what they hold. O(arcs).
void append_arcs(const LocalFrame& frame, const std::vector<Arc>& arcs, ExactShape& shape);

} // namespace dsc::scenes
