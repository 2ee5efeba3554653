// SPDX-License-Identifier: MIT
// Named figures: the results of measures, in the order of measurement.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dsc::scenes {

struct Figure;
using Figures = std::vector<Figure>;

/// NaN: could not be measured. A figure may have several figures as its parts.
using Value = std::variant<double, Figures>;

struct Figure {
    std::string name;
    Value value;
};

/// The number with this name; for a part, a name such as "jaggedness.largest_excess_deg". Throws
/// InputError, which lists all figures, if there is none or it is not a number. O(figures).
[[nodiscard]] double number(const Figures& figures, std::string_view name);

} // namespace dsc::scenes
