// SPDX-License-Identifier: MIT
// Closed curves of circular arcs and straight sides: exact shapes whose area has a closed form.
#pragma once

#include "shapes/outline.h"

#include <vector>

namespace dsc::scenes {

/// An arc: counter-clockwise about its centre if `end` is larger than `begin`, else clockwise.
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

/// Appends the closed curve along the arcs in their order: an outline with vertices on the arcs,
/// and its exact area; adds the area between outline and curve to `own_error`. A straight side
/// joins the end of an arc to the beginning of the next one, unless they coincide. Outlines run
/// counter-clockwise around their region. O(arcs).
void append_arcs(const LocalFrame& frame, const std::vector<Arc>& arcs, ExactShape& shape);

} // namespace dsc::scenes
