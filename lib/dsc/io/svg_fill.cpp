// SPDX-License-Identifier: MIT
#include "dsc/io/svg_fill.h"

#include "dsc/base/error.h"
#include "dsc/base/types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dsc {

namespace {

constexpr std::array viridis{
    "#46075a", "#471365", "#481d6f", "#482878", "#46327e", "#443b84", "#404588", "#3d4e8a",
    "#39568c", "#355f8d", "#31678e", "#2e6f8e", "#2a768e", "#277e8e", "#25858e", "#228d8d",
    "#1f948c", "#1e9c89", "#20a386", "#25ab82", "#2db27d", "#38b977", "#46c06f", "#56c667",
    "#67cc5c", "#7ad151", "#8ed645", "#a2da37", "#b8de29", "#cde11d", "#e2e418", "#f6e620"};
/// Okabe and Ito (2008) without black, and their tints.
constexpr std::array palette{"#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00",
                             "#cc79a7", "#f7d999", "#bbe1f6", "#99d8c7", "#99c7e0", "#eebf99"};

} // namespace

SvgFill fill_by_value(std::string name, std::span<const double> values, double low, double high) {
    if (!(low < high) || !std::isfinite(low) || !std::isfinite(high)) {
        throw InputError({.what = "not a range of values",
                          .where = "fill_by_value",
                          .value = std::to_string(low) + " to " + std::to_string(high),
                          .allowed = "finite, the first below the second"});
    }
    SvgFill fill{std::move(name), {viridis.begin(), viridis.end()}, {}};
    const double steps = static_cast<double>(viridis.size());
    fill.of.reserve(values.size());
    for (const double value : values) {
        const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
        fill.of.push_back(std::isnan(value)
                              ? no_id
                              : static_cast<std::uint32_t>(std::min(share * steps, steps - 1)));
    }
    return fill;
}

SvgFill fill_by_number(std::string name, std::span<const std::int32_t> numbers) {
    SvgFill fill{std::move(name), {palette.begin(), palette.end()}, {}};
    fill.of.reserve(numbers.size());
    for (const std::int32_t number : numbers) {
        fill.of.push_back(number < 0 ? no_id
                                     : static_cast<std::uint32_t>(number) %
                                           static_cast<std::uint32_t>(palette.size()));
    }
    return fill;
}

} // namespace dsc
