// SPDX-License-Identifier: MIT
// Closed parametric curves. The exact image of a shape under a flow is computed from its curve, not
// from the polygon with which a mesh starts.
#pragma once

#include "shapes/outline.h"
#include "shapes/shapes.h"

#include <functional>
#include <span>
#include <vector>

namespace dsc::scenes {

/// A simple closed curve, counter-clockwise.
struct ParametricCurve {
    std::function<Point<double>(double)> point; ///< for parameters in [0, 1)
    std::vector<double> corners; ///< parameters at which the tangent jumps, ascending
    double area = 0.0;           ///< in closed form
};

[[nodiscard]] ParametricCurve circle_curve(const Point<double>& centre, double radius);
[[nodiscard]] ParametricCurve polygon_curve(std::span<const Point<double>> corners);
[[nodiscard]] ParametricCurve slotted_disc_curve(const SlottedDisc& disc);

} // namespace dsc::scenes
