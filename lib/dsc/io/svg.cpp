// SPDX-License-Identifier: MIT
#include "dsc/io/pictures.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/io/part_file.h"
#include "dsc/queries/phases.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace dsc {

namespace {

template <class Real>
Rectangle box_of(const Complex<Real>& complex) {
    const auto [low, high] = bounds_of(complex);
    return low.x() <= high.x()
               ? Rectangle{low.template cast<double>(), high.template cast<double>()}
               : Rectangle{};
}

// From the plane to pixels; y turns downwards.
class View {
public:
    View(const Rectangle& box, const SvgOptions& options)
        : low_x_(box.low.x()), high_y_(box.high.y()), margin_(options.margin_px) {
        const Point<double> sides = box.high - box.low;
        const double extent = sides.maxCoeff();
        scale_ = extent > 0 ? options.size_px / extent : 1;
        width_ = sides.x() * scale_ + 2 * margin_;
        height_ = sides.y() * scale_ + 2 * margin_;
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
        const Point<double> sides = options.view->high - options.view->low;
        require(sides.minCoeff() > 0 && sides.allFinite(), "view", sides.minCoeff(),
                "a positive width and height");
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
    const std::optional<SvgFill>& fill = options.fill;
    const auto grey = static_cast<std::uint32_t>(fill ? fill->colours.size() : 0);
    std::map<std::uint32_t, std::vector<Triangle>> members; // by phase, or by place in `colours`
    for (const Triangle t : triangles(complex)) {
        members[fill ? std::min(fill->of[t.id], grey) : complex.phase(t)].push_back(t);
    }
    for (const auto& [key, list] : members) {
        const bool is_grey = fill && key == grey;
        const std::string name = is_grey ? "none" : std::to_string(key);
        write_path(file, complex, view, options, (fill ? fill->name : "phase") + '-' + name,
                   is_grey ? "#bbbbbb"
                   : fill  ? fill->colours[key]
                           : colour_of(key, options),
                   list);
    }
}

void write_marks(PartFile& file, const View& view, const SvgOptions& options) {
    for (const SvgMark& mark : options.marks) {
        file << "<path class=\"mark\" fill=\"none\" stroke=\"" << escape_xml(options.mark_colour)
             << "\" stroke-width=\"3\" d=\"M";
        view.put(file, Point<double>(mark.x, mark.y));
        // A ring of 12 pixels around the point, from the ring's leftmost point on.
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

template <class Real>
void write_svg(const Complex<Real>& complex, const std::string& path, const SvgOptions& options) {
    check(options);
    const std::size_t fills = options.fill ? options.fill->of.size() : complex.triangle_bound();
    require(fills == complex.triangle_bound(), "fill", static_cast<double>(fills),
            to_text(complex.triangle_bound()) + " entries, one for each id of a triangle");
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
