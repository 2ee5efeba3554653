// SPDX-License-Identifier: MIT
#include "scenes/output/pictures.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/io/pictures.h"
#include "dsc/quality/measures.h"

#include <algorithm>
#include <sstream>

namespace dsc::scenes {

namespace {

constexpr std::array viridis{
    "#46075a", "#471365", "#481d6f", "#482878", "#46327e", "#443b84", "#404588", "#3d4e8a",
    "#39568c", "#355f8d", "#31678e", "#2e6f8e", "#2a768e", "#277e8e", "#25858e", "#228d8d",
    "#1f948c", "#1e9c89", "#20a386", "#25ab82", "#2db27d", "#38b977", "#46c06f", "#56c667",
    "#67cc5c", "#7ad151", "#8ed645", "#a2da37", "#b8de29", "#cde11d", "#e2e418", "#f6e620"};
// Okabe and Ito (2008) without black, and their tints.
constexpr std::array palette{"#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00",
                             "#cc79a7", "#f7d999", "#bbe1f6", "#99d8c7", "#99c7e0", "#eebf99"};

bool is_fill(Layer layer) { return layer <= Layer::submeshes; }

[[noreturn]] void refuse_layers(const char* what, const std::string& names) {
    throw InputError({.what = what,
                      .where = "--pictures",
                      .value = "'" + names + "'",
                      .allowed = "with commas between them, one of phases, quality, targets and "
                                 "submeshes; edges, interface, events"});
}

template <class Values>
const Values* find_array(std::span<const VtuArray> arrays, const std::string& name) {
    const auto found = std::ranges::find(arrays, name, &VtuArray::name);
    return found == arrays.end() ? nullptr : std::get_if<Values>(&found->values);
}

} // namespace

SvgFill fill_by_value(std::string name, std::span<const double> values, double low, double high) {
    require(low < high && std::isfinite(low) && std::isfinite(high), "fill_by_value: high", high,
            "finite, and above " + to_text(low));
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

namespace {

template <class Real>
SvgFill by_quality(const Complex<Real>& complex) {
    std::vector<double> values(complex.triangle_bound(), 0);
    for (const Triangle t : triangles(complex)) {
        values[t.id] = static_cast<double>(quality(complex, t));
    }
    return fill_by_value("quality", values, 0, 1);
}

template <class Real>
SvgFill by_target(const Complex<Real>& complex, const std::vector<double>& lengths) {
    double low = std::numeric_limits<double>::infinity();
    double high = 0;
    for (const Triangle t : triangles(complex)) {
        low = std::min(low, lengths[t.id]);
        high = std::max(high, lengths[t.id]);
    }
    // Where all are of one length, they are all as dark.
    return fill_by_value("targets", lengths, low, high > low ? high : 2 * low);
}

} // namespace

Layers parse_layers(const std::string& names) {
    Layers layers;
    std::istringstream words(names);
    for (std::string word; std::getline(words, word, ',');) {
        const auto layer = value_in(layer_names, word);
        if (!layer) {
            refuse_layers("unknown layer", names);
        }
        layers.insert(*layer);
    }
    if (layers.empty() || std::ranges::count_if(layers, is_fill) > 1) {
        refuse_layers(layers.empty() ? "no layers" : "triangles have one colour", names);
    }
    return layers;
}

template <class Real>
void write_picture(const Complex<Real>& complex, const Layers& layers,
                   std::span<const VtuArray> arrays, std::span<const Event> events,
                   const std::string& title, const std::string& path) {
    SvgOptions options;
    options.title = title;
    options.edge_width_px = layers.contains(Layer::edges) ? 0.5 : 0;
    options.interface_width_px = layers.contains(Layer::interface) ? 2 : 0;
    if (layers.contains(Layer::quality)) {
        options.fill = by_quality(complex);
    }
    if (layers.contains(Layer::targets)) {
        if (const auto* lengths = find_array<std::vector<double>>(arrays, "size")) {
            options.fill = by_target(complex, *lengths);
        }
    }
    if (layers.contains(Layer::submeshes)) {
        if (const auto* owners = find_array<std::vector<std::int32_t>>(arrays, "submesh")) {
            options.fill = fill_by_number("submesh", *owners);
        }
    }
    if (layers.contains(Layer::events)) {
        for (const Event& event : events) {
            options.marks.push_back(
                {.x = event.x,
                 .y = event.y,
                 .text = std::string(to_string(event.kind)) + " at " + to_text(event.time)});
        }
    }
    write_svg(complex, path, options);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void write_picture(const Complex<Real>&, const Layers&, std::span<const VtuArray>,    \
                                std::span<const Event>, const std::string&, const std::string&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
