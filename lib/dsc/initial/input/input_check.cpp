// SPDX-License-Identifier: MIT
#include "dsc/initial/input/input_check.h"

#include "dsc/base/error.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/input/line.h"
#include "dsc/initial/input/line_cutting.h"
#include "dsc/initial/input/shape_network.h"
#include "dsc/initial/input/thinning.h"
#include "dsc/initial/rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

namespace dsc::initial {

namespace {

using Points = std::vector<Point<double>>;

// --- the domain and the options ------------------------------------------------------------------

// The spacing of the lattice. If edges grow, the lattice is as coarse as they may become: an eighth
// of the smaller side of the domain is small enough for triangles of good quality, and costs
// nothing.
double spacing_of(const InitialOptions& options, double side) {
    if (options.sizes.is_uniform()) {
        return options.edge_length;
    }
    const double coarse = std::max(options.edge_length, side / 8);
    return options.sizes.longest > 0 ? std::min(coarse, options.sizes.longest) : coarse;
}

template <class Real>
Lattice check_domain(const Rectangle& domain, const InitialOptions& options) {
    const double h = options.edge_length;
    require(std::isfinite(h) && h > 0, "edge_length", h, "a finite number above 0");
    require(options.improve_rounds >= 0, "improve_rounds", options.improve_rounds, "0 or more");
    require(options.border_tolerance >= min_margin && options.border_tolerance <= 0.1,
            "border_tolerance", options.border_tolerance,
            to_text(min_margin) + " to 0.1 edge lengths");
    const Point<double> low = rounded<Real>(domain.low);
    const Point<double> high = rounded<Real>(domain.high);
    if (!low.allFinite() || !high.allFinite()) {
        throw InputError({.what = "a coordinate is not finite",
                          .where = "domain",
                          .value = to_text(domain.low) + " to " + to_text(domain.high),
                          .allowed = "finite coordinates"});
    }
    const double width = high.x() - low.x();
    const double height = high.y() - low.y();
    if (!(width > 0) || !(height > 0) || !std::isfinite(width * height)) {
        throw InputError({.what = "the rectangle is empty or out of range",
                          .where = "domain",
                          .value = to_text(domain.low) + " to " + to_text(domain.high),
                          .allowed = "low below high in x and y, and an area that is finite"});
    }
    constexpr double smallest = min_initial_edge_length;
    require(h >= smallest && h <= 1 / smallest, "edge_length", h,
            to_text(smallest) + " to " + to_text(1 / smallest) +
                "; scale other scenes with choose_frame");
    require(h <= std::min(width, height), "edge_length", h,
            "at most " + to_text(std::min(width, height)) + ", the smaller side of the domain");
    const double resolution = std::max(largest(low), largest(high)) *
                              static_cast<double>(std::numeric_limits<Real>::epsilon());
    require(h >= min_steps * resolution, "edge_length", h,
            "at least " + to_text(min_steps * resolution) +
                ", the resolution of coordinates of this size; move the scene to the origin with "
                "choose_frame");
    check_sizes(options.sizes, h);
    const double spacing = spacing_of(options, std::min(width, height));
    // An equilateral triangle has the area sqrt(3)/4 h^2.
    const double triangles = width / spacing * (height / spacing) / 0.43301270189221933;
    require(triangles <= max_triangles, "edge_length", h,
            "at most " + to_text(max_triangles) + " triangles, not about " + to_text(triangles));
    return fit_lattice(low, high, spacing);
}

// --- one path ------------------------------------------------------------------------------------

std::size_t count_points(std::span<const Shape> shapes) {
    std::size_t count = 0;
    for (const Shape& shape : shapes) {
        count += is_outside(shape) ? 0 : shape.outline.size();
        for (const Points& hole : shape.holes) {
            count += hole.size();
        }
    }
    return count;
}

std::size_t count_points(std::span<const Curve> curves) {
    std::size_t count = 0;
    for (const Curve& curve : curves) {
        count += curve.points.size();
    }
    return count;
}

void number_points(std::vector<Line>& lines) {
    for (Line& line : lines) {
        line.numbers.resize(line.given.size());
        std::iota(line.numbers.begin(), line.numbers.end(), 0U);
    }
}

std::vector<Line> lines_of(std::span<const Shape> shapes) {
    std::vector<Line> lines(shapes.size());
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        lines[k].path.name = name_of(shapes, k);
        lines[k].path.left = shapes[k].phase;
        lines[k].given = shapes[k].outline;
        if (Points& given = lines[k].given;
            given.size() == 1 || (!given.empty() && given.front() != given.back())) {
            given.push_back(Point<double>(given.front()));
        }
    }
    number_points(lines);
    return lines;
}

std::vector<Line> lines_of(std::span<const Curve> curves) {
    std::vector<Line> lines(curves.size());
    for (std::size_t k = 0; k < curves.size(); ++k) {
        lines[k].path.name = "curve " + std::to_string(k);
        for (const Phase phase : {curves[k].left, curves[k].right}) {
            require(phase != border_phase, lines[k].path.name, phase,
                    "phases from 0 to 4294967294; the next one is reserved");
        }
        lines[k].path.left = curves[k].left;
        lines[k].path.right = curves[k].right;
        lines[k].given = curves[k].points;
    }
    number_points(lines);
    return lines;
}

void check_phases(const CheckedPath& path) {
    require(path.right != path.left, path.name, path.left, "two phases that differ on its sides");
}

[[noreturn]] void refuse_doubled(const Line& line, std::size_t edge) {
    throw InputError(
        {.what = line.given[edge] == line.given[edge + 1]
                     ? "the edge has length 0"
                     : "points collide when rounded to the scalar of the complex",
         .where = line.edge(edge),
         .value = line.ends_of_edge(edge),
         .allowed = "points that differ from the one before, unless detail may be left out"});
}

// Rounds the points, which must be finite. Of consecutive equal points the first is kept; enough
// points must remain.
template <class Real>
void round_points(Line& line, Detail detail, InputReport& report) {
    std::vector<std::uint32_t> kept;
    Points& points = line.path.points;
    points.reserve(line.given.size());
    for (std::uint32_t i = 0; i < line.given.size(); ++i) {
        points.push_back(rounded<Real>(line.given[i]));
        if (!line.given[i].allFinite() || !points.back().allFinite()) {
            throw InputError({.what = "a coordinate is not finite",
                              .where = line.point(i),
                              .value = to_text(line.given[i]),
                              .allowed = "finite coordinates"});
        }
        if (i == 0 || points[i - 1] != points[i]) {
            kept.push_back(i);
        } else if (detail == Detail::keep && line.given.size() > 2) {
            refuse_doubled(line, i - 1);
        }
    }
    report.thinned += line.given.size() - kept.size();
    keep_points(line, kept);
    const std::size_t count = points.size() - (line.is_closed() ? 1 : 0);
    const bool may_be_dropped = line.is_outline() && detail == Detail::thin && count > 0;
    if (!may_be_dropped && count < (line.is_closed() || line.is_outline() ? 3 : 2)) {
        throw InputError({.what = "too few points",
                          .where = line.path.name,
                          .value = std::to_string(count),
                          .allowed = "2 or more, and 3 or more different ones around a region"});
    }
}

void check_places(const Line& line, const Lattice& lattice, double h) {
    const Points& points = line.path.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool may_touch = !line.is_outline() && (i == 0 || i + 1 == points.size());
        const double distance = distance_to_sides(lattice, points[i]);
        if (!(distance >= min_margin * h) && !(may_touch && distance == 0)) {
            throw InputError(
                {.what = "the point is outside the domain or too close to a side of it",
                 .where = line.point(i),
                 .value = to_text(points[i]),
                 .allowed = "a distance of at least " + to_text(min_margin * h) +
                            " to the sides of " + to_text(lattice.low) + " to " +
                            to_text(lattice.high) +
                            "; the ends of a curve may lie on them exactly"});
        }
    }
}

// Rounds each line, and checks it by itself.
template <class Real>
void check_lines(std::vector<Line>& lines, const Lattice& lattice, const InitialOptions& options,
                 InputReport& report) {
    const double h = options.edge_length;
    double pieces = 0;
    for (Line& line : lines) {
        check_phases(line.path);
        round_points<Real>(line, options.detail, report);
    }
    std::erase_if(lines, [&](const Line& line) {
        return line.is_outline() && is_dropped(line.path.points, line.path.name, options, report);
    });
    for (const Line& line : lines) {
        check_places(line, lattice, h);
        for (std::size_t i = 0; i + 1 < line.given.size(); ++i) {
            pieces += piece_count(line, i, h);
        }
        require(pieces <= max_pieces, line.path.name, pieces,
                "at most " + to_text(max_pieces) + " pieces of the interface up to its end");
    }
}

// The orientation from the turn at the lowest of the leftmost points, which is convex in a simple
// polygon.
bool is_counter_clockwise(std::span<const Point<double>> points) {
    const auto at =
        std::min_element(points.begin(), points.end(), [](const auto& a, const auto& b) {
            return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
        });
    const auto before = at == points.begin() ? std::prev(points.end()) : std::prev(at);
    const auto after = std::next(at) == points.end() ? points.begin() : std::next(at);
    return orientation<double>(*before, *at, *after) > 0;
}

} // namespace

template <class Real, class Drawn>
CheckedInput check_input(const Rectangle& domain, std::span<const Drawn> drawn,
                         const InitialOptions& options, InputReport& report) {
    CheckedInput input{check_domain<Real>(domain, options)};
    std::vector<Line> lines;
    std::optional<ShapeNetwork> network;
    if constexpr (std::is_same_v<Drawn, Shape>) {
        network = network_of<Real>(drawn, input.lattice, options, report);
    }
    if (network) {
        lines = std::move(network->lines);
        input.background = network->background;
        input.has_outside = network->has_outside;
    } else {
        lines = lines_of(drawn);
    }
    check_lines<Real>(lines, input.lattice, options, report);
    report.points = count_points(drawn);
    std::vector<Points> cut = cut_apart<Real>(lines, input.lattice, options, report);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        CheckedPath& path = input.paths.emplace_back(std::move(lines[k].path));
        const bool clockwise =
            !path.right &&
            !is_counter_clockwise(std::span(path.points).first(path.points.size() - 1));
        path.points = std::move(cut[k]);
        if (clockwise) {
            std::reverse(path.points.begin(), path.points.end() - 1);
            path.points.back() = path.points.front();
        }
    }
    return input;
}

#define DSC_INSTANTIATE(Real, Drawn)                                                               \
    template CheckedInput check_input<Real>(const Rectangle&, std::span<const Drawn>,              \
                                            const InitialOptions&, InputReport&);
DSC_INSTANTIATE(double, Shape)
DSC_INSTANTIATE(double, Curve)
DSC_INSTANTIATE(float, Shape)
DSC_INSTANTIATE(float, Curve)
#undef DSC_INSTANTIATE

} // namespace dsc::initial
