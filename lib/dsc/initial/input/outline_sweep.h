// SPDX-License-Identifier: MIT
// Do polygons cross or touch, and which lies in which? One sweep over all of their edges, in
// O(n log n) and with exact signs (M. I. Shamos, D. Hoey, "Geometric intersection problems", 1976).
#pragma once

#include "dsc/base/types.h"

#include <optional>
#include <span>
#include <vector>

namespace dsc::initial {

/// A closed polygon; edge i runs from point i to the next one.
struct SweepPolygon {
    std::span<const Point<double>> points;
    bool counter_clockwise = true;
};

/// Two edges that have a point in common and should not; the first comes first in the input.
struct Contact {
    std::uint32_t polygon = 0;
    std::uint32_t edge = 0;
    std::uint32_t other_polygon = 0;
    std::uint32_t other_edge = 0;
};

struct SweepResult {
    std::optional<Contact> contact; ///< one of them, if there are any
    /// The innermost polygon around each, or no_id; holds only without a contact.
    std::vector<std::uint32_t> parent;
};

/// All coordinates must be finite. Any contact counts, except the common vertex of two successive
/// edges that do not overlap.
SweepResult sweep(std::span<const SweepPolygon> polygons);

} // namespace dsc::initial
