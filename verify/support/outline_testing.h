// SPDX-License-Identifier: MIT
// What the tests of shapes and of exact solutions ask of an outline.
#pragma once

#include "dsc/initial/input/contacts.h"
#include "shapes/outline.h"

#include <algorithm>
#include <span>
#include <vector>

namespace dsc::test {

inline double longest_edge(const scenes::Outline& outline) {
    double longest = (outline.front() - outline.back()).norm();
    for (std::size_t i = 1; i < outline.size(); ++i) {
        longest = std::max(longest, (outline[i] - outline[i - 1]).norm());
    }
    return longest;
}

/// True if no two edges of all the outlines meet, except that neighbours share their common vertex.
inline bool is_simple(std::span<const scenes::Outline> outlines) {
    std::vector<Point<double>> points;
    std::vector<initial::NetworkLine> lines;
    for (const scenes::Outline& outline : outlines) {
        const auto first = static_cast<std::uint32_t>(points.size());
        const auto count = static_cast<std::uint32_t>(outline.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t after = i + 1 < count ? i + 1 : 0;
            if (outline[i] == outline[after]) {
                return false;
            }
            lines.push_back({first + i, first + after});
        }
        points.insert(points.end(), outline.begin(), outline.end());
    }
    return !initial::find_contact(points, lines);
}

inline bool is_simple(const scenes::Outline& outline) { return is_simple(std::span(&outline, 1)); }

} // namespace dsc::test
