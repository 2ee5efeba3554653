// SPDX-License-Identifier: MIT
// Everything that is said of a shape at one moment against the shape that it should be.
#pragma once

#include "flows/exact.h"
#include "measures/jaggedness.h"

#include <span>
#include <string>

namespace dsc::scenes {

/// Lengths and areas in units of the domain.
struct ShapeErrors {
    double area = 0.0;
    double area_exact = 0.0;
    double symmetric_difference = 0.0; ///< area between the shape and the exact one
    double hausdorff = 0.0;            ///< largest distance of either curve from the other
    double perimeter = 0.0;
    Jaggedness jaggedness;
    std::string exact_shape;  ///< what it was compared with
    double exact_error = 0.0; ///< the area by which that may be off itself
};

/// `outlines` are what the interface is read as, `polygons` its vertices with straight edges: the
/// same where that is how it is read. Jaggedness is that of the vertices.
/// Throws InputError for an outline of fewer than three points or with one that is not finite.
[[nodiscard]] ShapeErrors measure_shape(std::span<const Outline> outlines,
                                        std::span<const Outline> polygons, const ExactShape& exact);

} // namespace dsc::scenes
