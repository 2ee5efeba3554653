// SPDX-License-Identifier: MIT
// The Hausdorff distance: the largest distance from a point of either curve to the other curve.
#pragma once

#include "shapes/outline.h"

#include <span>

namespace dsc::scenes {

struct HausdorffDistance {
    double first_to_second = 0.0; ///< largest distance from a point of the first to the second
    double second_to_first = 0.0;
    Point<double> farthest{0.0, 0.0}; ///< the point at which the larger of the two is found

    [[nodiscard]] double distance() const {
        return first_to_second > second_to_first ? first_to_second : second_to_first;
    }
};

/// The distance between two sets of closed polylines, over all points of their edges, not only
/// their vertices. The result never exceeds the true value (except for rounding) and is at most
/// 1e-10 of the size of the box around both below it. Infinite if exactly one of the sets is empty.
/// Throws InputError for an outline with fewer than three points, or with a point that is not
/// finite.
[[nodiscard]] HausdorffDistance hausdorff(std::span<const Outline> first,
                                          std::span<const Outline> second);

} // namespace dsc::scenes
