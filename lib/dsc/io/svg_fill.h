// SPDX-License-Identifier: MIT
// Colours of triangles by something other than their phase: a number, or which group they are in.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dsc {

/// One colour for each triangle.
struct SvgFill {
    std::string name;                 ///< class names in the file are name-0, name-1, ...
    std::vector<std::string> colours; ///< as in CSS
    /// By id of the triangle: a position in `colours`; beyond the last one, it is grey.
    std::vector<std::uint32_t> of;
};

/// From dark blue at `low` and below to yellow at `high` and above, in 32 steps of equal lightness
/// (the map viridis, readable by the colour-blind and in grey). NaN is grey. Throws InputError
/// unless low < high, both finite.
[[nodiscard]] SvgFill fill_by_value(std::string name, std::span<const double> values, double low,
                                    double high);

/// A colour for each number, the palette again and again; negative numbers are grey.
[[nodiscard]] SvgFill fill_by_number(std::string name, std::span<const std::int32_t> numbers);

} // namespace dsc
