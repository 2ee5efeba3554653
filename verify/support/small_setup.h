// SPDX-License-Identifier: MIT
// Whether a scene is small enough to be made in a test of any scenes.
#pragma once

#include "scenes/scene.h"

#include <cstddef>

namespace dsc::test {

/// Of edges of length `h`: about so many triangles at most, and so many points of outlines and
/// curves and edges along them.
inline bool is_small(const scenes::Setup& setup, double h, double most_triangles,
                     std::size_t most_points) {
    const Point<double> size = setup.domain.high - setup.domain.low;
    std::size_t points = 0;
    double length = 0;
    for (const scenes::Outline& outline : setup.outlines) {
        points += outline.size();
        length += scenes::perimeter(outline);
    }
    for (const dsc::Curve& curve : setup.curves) {
        points += curve.points.size();
        length += scenes::perimeter(curve.points);
    }
    return size.prod() / (h * h) < most_triangles && points < most_points &&
           length / h < static_cast<double>(most_points);
}

} // namespace dsc::test
