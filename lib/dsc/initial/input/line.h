// SPDX-License-Identifier: MIT
// An outline or a curve during the checks.
#pragma once

#include "dsc/base/error.h"
#include "dsc/initial/input/input_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace dsc::initial {

/// The name of shape k in messages.
[[nodiscard]] inline std::string name_of(std::span<const Shape> shapes, std::size_t k) {
    return shapes[k].name.empty() ? "shape " + std::to_string(k) : shapes[k].name;
}

/// A closed line repeats its first point at the end.
struct Line {
    CheckedPath path;                   ///< its points, rounded, and finally cut into pieces
    std::vector<Point<double>> given;   ///< the same points before they were rounded
    std::vector<std::uint32_t> numbers; ///< of these points, as the caller counts them

    [[nodiscard]] bool is_outline() const { return !path.right; }
    [[nodiscard]] bool is_closed() const {
        return path.points.size() > 1 && path.points.front() == path.points.back();
    }
    [[nodiscard]] std::string point(std::size_t i) const {
        return path.name + ", point " + std::to_string(numbers[i]);
    }
    [[nodiscard]] std::string edge(std::size_t i) const {
        return path.name + ", edge " + std::to_string(numbers[i]);
    }
    [[nodiscard]] std::string ends_of_edge(std::size_t i) const {
        return to_text(given[i]) + " to " + to_text(given[i + 1]);
    }
};

/// Keeps the points with these indices.
inline void keep_points(Line& line, std::span<const std::uint32_t> kept) {
    const auto keep = [kept](auto& list) {
        std::remove_cvref_t<decltype(list)> left;
        left.reserve(kept.size());
        std::ranges::transform(kept, std::back_inserter(left),
                               [&](std::uint32_t i) { return list[i]; });
        list.swap(left);
    };
    keep(line.path.points);
    keep(line.given);
    keep(line.numbers);
}

/// The distance of a point from the nearest side of the domain; negative outside.
[[nodiscard]] inline double distance_to_sides(const Lattice& lattice, const Point<double>& p) {
    return std::min({p.x() - lattice.low.x(), lattice.high.x() - p.x(), p.y() - lattice.low.y(),
                     lattice.high.y() - p.y()});
}

/// A length that is a whole number of target lengths, up to rounding, is cut into as many pieces.
/// Counted before rounding, so that float and double are cut alike.
[[nodiscard]] inline double piece_count(const Line& line, std::size_t edge, double h) {
    constexpr double whole_number_slack = 1e-9;
    const double length = (line.given[edge + 1] - line.given[edge]).norm();
    return std::max(1.0, std::ceil(length / h * (1 - whole_number_slack)));
}

} // namespace dsc::initial
