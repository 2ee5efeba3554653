// SPDX-License-Identifier: MIT
// Functions of outlines for the tests of shapes and of exact solutions.
#pragma once

#include "dsc/geometry/contacts.h"
#include "dsc/geometry/points.h"
#include "shapes/outline.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace dsc::test {

inline double uniform(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline scenes::Outline square(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

/// A star-shaped polygon about the origin with random radii.
inline scenes::Outline random_star(std::mt19937_64& random, int count) {
    scenes::Outline outline;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + uniform(random, 0.0, 0.9)) / count;
        const double radius = uniform(random, 0.3, 1.0);
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return outline;
}

inline scenes::Outline transformed(scenes::Outline outline, double scale,
                                   const Point<double>& shift) {
    for (Point<double>& p : outline) {
        p = scale * p + shift;
    }
    return outline;
}

inline double longest_edge(const scenes::Outline& outline) {
    double longest = (outline.front() - outline.back()).norm();
    for (std::size_t i = 1; i < outline.size(); ++i) {
        longest = std::max(longest, (outline[i] - outline[i - 1]).norm());
    }
    return longest;
}

/// The distance of a point from the closed polygons.
inline double distance_from(std::span<const scenes::Outline> outlines, const Point<double>& p) {
    double smallest = INFINITY;
    for (const scenes::Outline& outline : outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point<double>& next = outline[(i + 1) % outline.size()];
            smallest = std::min(smallest, distance<double>(p, outline[i], next));
        }
    }
    return smallest;
}

inline double distance_from(const scenes::Outline& outline, const Point<double>& p) {
    return distance_from(std::span(&outline, 1), p);
}

/// Whether no two edges of the outlines meet, except neighbours at their common vertex.
inline bool is_simple(std::span<const scenes::Outline> outlines) {
    std::vector<Point<double>> points;
    std::vector<NetworkLine> lines;
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
    return !find_contact(points, lines);
}

inline bool is_simple(const scenes::Outline& outline) { return is_simple(std::span(&outline, 1)); }

} // namespace dsc::test
