// SPDX-License-Identifier: MIT
#include "measures/shape_errors.h"

#include "measures/hausdorff.h"
#include "measures/symmetric_difference.h"

namespace dsc::scenes {

ShapeErrors measure_shape(std::span<const Outline> outlines, std::span<const Outline> polygons,
                          const ExactShape& exact) {
    ShapeErrors errors;
    errors.area = signed_area(outlines);
    errors.area_exact = exact.area;
    errors.symmetric_difference = symmetric_difference(outlines, exact.outlines);
    errors.hausdorff = hausdorff(outlines, exact.outlines).distance();
    errors.perimeter = perimeter(outlines);
    errors.jaggedness = measure_jaggedness(polygons, exact.outlines);
    errors.exact_shape = exact.description;
    errors.exact_error = exact.own_error;
    return errors;
}

} // namespace dsc::scenes
