// SPDX-License-Identifier: MIT
#include "dsc/io/pictures.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/io/part_file.h"
#include "dsc/queries/phases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace dsc {

namespace {

constexpr std::array viridis{
    "#46075a", "#471365", "#481d6f", "#482878", "#46327e", "#443b84", "#404588", "#3d4e8a",
    "#39568c", "#355f8d", "#31678e", "#2e6f8e", "#2a768e", "#277e8e", "#25858e", "#228d8d",
    "#1f948c", "#1e9c89", "#20a386", "#25ab82", "#2db27d", "#38b977", "#46c06f", "#56c667",
    "#67cc5c", "#7ad151", "#8ed645", "#a2da37", "#b8de29", "#cde11d", "#e2e418", "#f6e620"};
// Okabe and Ito (2008) without black, and their tints.
constexpr std::array palette{"#e69f00", "#56b4e9", "#009e73", "#f0e442", "#0072b2", "#d55e00",
                             "#cc79a7", "#f7d999", "#bbe1f6", "#99d8c7", "#99c7e0", "#eebf99"};

template <class Real>
SvgBox box_of(const Complex<Real>& complex) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    SvgBox box{infinity, infinity, -infinity, -infinity};
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v).template cast<double>();
        box.low_x = std::min(box.low_x, p.x());
        box.low_y = std::min(box.low_y, p.y());
        box.high_x = std::max(box.high_x, p.x());
        box.high_y = std::max(box.high_y, p.y());
    }
    return box.low_x <= box.high_x ? box : SvgBox{};
}

// From the plane to pixels; y turns downwards.
class View {
public:
    View(const SvgBox& box, const SvgOptions& options)
        : low_x_(box.low_x), high_y_(box.high_y), margin_(options.margin_px) {
        const double width = box.high_x - box.low_x;
        const double height = box.high_y - box.low_y;
        const double extent = std::max(width, height);
        scale_ = extent > 0 ? options.size_px / extent : 1;
        width_ = width * scale_ + 2 * margin_;
        height_ = height * scale_ + 2 * margin_;
    }
    [[nodiscard]] double width() const { return width_; }
    [[nodiscard]] double height() const { return height_; }

    template <class Real>
    void put(PartFile& file, const Point<Real>& p) const {
        // A thousandth of a pixel is more than any screen or printer shows.
        file.fixed((static_cast<double>(p.x()) - low_x_) * scale_ + margin_, 3);
        file << ' ';
        file.fixed((high_y_ - static_cast<double>(p.y())) * scale_ + margin_, 3);
    }

private:
    double low_x_;
    double high_y_;
    double margin_;
    double scale_ = 1;
    double width_ = 0;
    double height_ = 0;
};

void check(const SvgOptions& options) {
    require(options.size_px > 0 && std::isfinite(options.size_px), "size_px", options.size_px,
            "a positive number of pixels");
    for (const auto& [name, width] : {std::pair("margin_px", options.margin_px),
                                      {"edge_width_px", options.edge_width_px},
                                      {"interface_width_px", options.interface_width_px}}) {
        require(width >= 0 && std::isfinite(width), name, width, "0 or more pixels");
    }
    require(!options.phase_colours.empty(), "phase_colours", 0, "one or more");
    if (options.view) {
        const SvgBox& box = *options.view;
        const double width = box.high_x - box.low_x;
        const double height = box.high_y - box.low_y;
        require(width > 0 && height > 0 && std::isfinite(width) && std::isfinite(height), "view",
                std::min(width, height), "a positive width and height");
    }
}

const std::string& colour_of(Phase phase, const SvgOptions& options) {
    const auto& list = options.phase_colours;
    if (phase < list.size() || list.size() == 1) {
        return list[std::min<std::size_t>(phase, list.size() - 1)];
    }
    return list[1 + (phase - 1) % (list.size() - 1)];
}

// All triangles of a colour are one path: a third of the bytes of polygons.
template <class Real>
void write_path(PartFile& file, const Complex<Real>& complex, const View& view,
                const SvgOptions& options, const std::string& name, const std::string& colour,
                std::span<const Triangle> members) {
    file << "<path class=\"" << escape_xml(name) << "\" fill=\"" << escape_xml(colour)
         << "\" stroke=\"";
    if (options.edge_width_px > 0) {
        file << escape_xml(options.edge_colour) << "\" stroke-width=\"" << options.edge_width_px;
    } else {
        // Hides the seams that anti-aliasing leaves between triangles.
        file << escape_xml(colour) << "\" stroke-width=\"0.5";
    }
    file << "\" d=\"";
    for (const Triangle t : members) {
        char command = 'M';
        for (const Vertex v : complex.vertices_of(t)) {
            file << command;
            view.put(file, complex.position(v));
            command = 'L';
        }
        file << "Z\n";
    }
    file << "\"/>\n";
}

template <class Real>
void write_triangles(PartFile& file, const Complex<Real>& complex, const View& view,
                     const SvgOptions& options) {
    if (!options.fill) {
        std::map<Phase, std::vector<Triangle>> members;
        for (const Triangle t : triangles(complex)) {
            members[complex.phase(t)].push_back(t);
        }
        for (const auto& [phase, list] : members) {
            write_path(file, complex, view, options, "phase-" + std::to_string(phase),
                       colour_of(phase, options), list);
        }
        return;
    }
    const SvgFill& fill = *options.fill;
    std::vector<std::vector<Triangle>> members(fill.colours.size() + 1);
    for (const Triangle t : triangles(complex)) {
        members[std::min<std::size_t>(fill.of[t.id], fill.colours.size())].push_back(t);
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (!members[i].empty()) {
            const bool is_none = i == fill.colours.size();
            write_path(file, complex, view, options,
                       fill.name + '-' + (is_none ? "none" : std::to_string(i)),
                       is_none ? "#bbbbbb" : fill.colours[i], members[i]);
        }
    }
}

void write_marks(PartFile& file, const View& view, const SvgOptions& options) {
    for (const SvgMark& mark : options.marks) {
        file << "<path class=\"mark\" fill=\"none\" stroke=\"" << escape_xml(options.mark_colour)
             << "\" stroke-width=\"3\" d=\"M";
        view.put(file, Point<double>(mark.x, mark.y));
        // A ring of 12 pixels around it, from its leftmost point.
        file << "m-12 0a12 12 0 1 0 24 0a12 12 0 1 0 -24 0\"><title>" << escape_xml(mark.text)
             << "</title></path>\n";
    }
}

template <class Real>
void write_interface(PartFile& file, const Complex<Real>& complex, const View& view,
                     const SvgOptions& options) {
    file << "<path class=\"interface\" fill=\"none\" stroke-linecap=\"round\" stroke=\""
         << escape_xml(options.interface_colour) << "\" stroke-width=\""
         << options.interface_width_px << "\" d=\"";
    for (const Edge e : edges(complex)) {
        if (!is_interface(complex, e)) {
            continue;
        }
        const auto v = complex.vertices_of(e);
        file << 'M';
        view.put(file, complex.position(v[0]));
        file << 'L';
        view.put(file, complex.position(v[1]));
        file << '\n';
    }
    file << "\"/>\n";
}

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

template <class Real>
void write_svg(const Complex<Real>& complex, const std::string& path, const SvgOptions& options) {
    check(options);
    if (options.fill && options.fill->of.size() != complex.triangle_bound()) {
        throw InputError(
            {.what = "not a colour for each triangle",
             .where = "write_svg",
             .value = std::to_string(options.fill->of.size()) + " entries",
             .allowed = std::to_string(complex.triangle_bound()) + ", one for each id"});
    }
    const View view(options.view ? *options.view : box_of(complex), options);
    PartFile file(path);
    file << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"";
    file.fixed(view.width(), 3) << "\" height=\"";
    file.fixed(view.height(), 3) << "\" viewBox=\"0 0 ";
    file.fixed(view.width(), 3) << ' ';
    file.fixed(view.height(), 3) << "\" stroke-linejoin=\"round\">\n";
    if (!options.title.empty()) {
        file << "<title>" << escape_xml(options.title) << "</title>\n";
    }
    write_triangles(file, complex, view, options);
    if (options.interface_width_px > 0) {
        write_interface(file, complex, view, options);
    }
    write_marks(file, view, options);
    file << "</svg>\n";
    file.commit();
}

template void write_svg(const Complex<double>&, const std::string&, const SvgOptions&);
template void write_svg(const Complex<float>&, const std::string&, const SvgOptions&);

} // namespace dsc
