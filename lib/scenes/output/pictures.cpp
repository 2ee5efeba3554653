// SPDX-License-Identifier: MIT
#include "scenes/output/pictures.h"

#include "dsc/base/error.h"
#include "dsc/base/names.h"
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
[[noreturn]] void refuse_layers(const char* what, const std::string& names) {
    throw InputError({.what = what,
                      .where = "--pictures",
                      .value = "'" + names + "'",
                      .allowed = "phases or quality, and edges and interface, with commas "
                                 "between them"});
}

// From dark blue at 0 to yellow at 1, in 32 steps of equal lightness (the map viridis, readable by
// the colour-blind and in grey).
template <class Real>
SvgFill by_quality(const Complex<Real>& complex) {
    constexpr double steps = viridis.size();
    SvgFill fill{"quality",
                 {viridis.begin(), viridis.end()},
                 std::vector<std::uint32_t>(complex.triangle_bound(), 0)};
    for (const Triangle t : triangles(complex)) {
        const auto share = std::clamp(static_cast<double>(quality(complex, t)), 0.0, 1.0);
        fill.of[t.id] = static_cast<std::uint32_t>(std::min(share * steps, steps - 1));
    }
    return fill;
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
    if (layers.empty() || (layers.contains(Layer::phases) && layers.contains(Layer::quality))) {
        refuse_layers(layers.empty() ? "no layers" : "two layers that colour the triangles", names);
    }
    return layers;
}

template <class Real>
void write_picture(const Complex<Real>& complex, const Layers& layers, const std::string& title,
                   const std::string& path) {
    SvgOptions options;
    options.title = title;
    options.edge_width_px = layers.contains(Layer::edges) ? 0.5 : 0;
    options.interface_width_px = layers.contains(Layer::interface) ? 2 : 0;
    if (layers.contains(Layer::quality)) {
        options.fill = by_quality(complex);
    }
    write_svg(complex, path, options);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template void write_picture(const Complex<Real>&, const Layers&, const std::string&,           \
                                const std::string&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
