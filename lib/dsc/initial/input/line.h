// SPDX-License-Identifier: MIT
// An outline or a curve, while it is checked.
#pragma once

#include "dsc/base/error.h"
#include "dsc/initial/input/input_check.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dsc::initial {

/// In messages.
[[nodiscard]] inline std::string name_of(std::span<const Shape> shapes, std::size_t k) {
    return shapes[k].name.empty() ? "shape " + std::to_string(k) : shapes[k].name;
}

/// A closed line repeats its first point at the end.
struct Line {
    CheckedPath path;                   ///< its points are rounded, and cut in the end
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

} // namespace dsc::initial
