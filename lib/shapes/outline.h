// SPDX-License-Identifier: MIT
// Closed polygons: the first shapes of scenes, and the shapes that measures compare.
#pragma once

#include "dsc/base/types.h"

#include <Eigen/Geometry>

#include <span>
#include <string>
#include <vector>

namespace dsc::scenes {

/// One simple closed polygon; the first point is not repeated at the end. Counter-clockwise around
/// a region, clockwise around a hole in one.
using Outline = std::vector<Point<double>>;

/// The area, positive for a counter-clockwise outline. Computed relative to the first vertex and
/// with a compensated sum, so that neither an offset nor the number of vertices costs digits.
[[nodiscard]] double signed_area(const Outline& outline);

/// Sum of the signed areas: the area of a region whose holes run clockwise.
[[nodiscard]] double signed_area(std::span<const Outline> outlines);

[[nodiscard]] double perimeter(const Outline& outline);
[[nodiscard]] double perimeter(std::span<const Outline> outlines);

[[nodiscard]] Outline reversed(Outline outline);

/// Throws InputError unless the outline has at least three points and all of them are finite.
void check_outline(const Outline& outline, const std::string& where);

/// The box around both sets of outlines, each of which is checked.
[[nodiscard]] Eigen::AlignedBox2d box_around(std::span<const Outline> first,
                                             std::span<const Outline> second,
                                             const std::string& where);

/// The exact shape at some time, against which errors are measured.
struct ExactShape {
    std::vector<Outline> outlines;
    double area = 0.0;      ///< exact, of the true shape rather than of its outlines
    double own_error = 0.0; ///< estimate of the area between the outlines and the true shape
};

} // namespace dsc::scenes
