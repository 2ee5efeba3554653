// SPDX-License-Identifier: MIT
#include "dsc/initial/input/input_check.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/input/outline_sweep.h"
#include "dsc/initial/rounding.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace dsc::initial {

namespace {

std::string text(double value) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

std::string text(const Point<double>& point) {
    return "(" + text(point.x()) + ", " + text(point.y()) + ")";
}

std::string shape_name(std::size_t shape) { return "shape " + std::to_string(shape); }

std::string vertex_name(std::size_t shape, std::size_t vertex) {
    return shape_name(shape) + ", vertex " + std::to_string(vertex);
}

std::string edge_name(std::size_t shape, std::size_t edge) {
    return shape_name(shape) + ", edge " + std::to_string(edge);
}

bool is_finite(const Point<double>& point) {
    return std::isfinite(point.x()) && std::isfinite(point.y());
}

double largest(const Point<double>& point) {
    return std::max(std::abs(point.x()), std::abs(point.y()));
}

// The nearest representable point; a coordinate beyond the range of the scalar becomes infinite.
template <class Real>
Point<double> rounded(const Point<double>& point) {
    constexpr auto limit = static_cast<double>(std::numeric_limits<Real>::max());
    if (largest(point) > limit) {
        return Point<double>::Constant(std::numeric_limits<double>::infinity());
    }
    return narrowed<Real>(point).template cast<double>();
}

template <class Real>
Lattice check_domain(const Rectangle& domain, const InitialOptions& options) {
    const double h = options.edge_length;
    if (!std::isfinite(h) || h <= 0) {
        throw InputError({.what = "edge length",
                          .where = "options",
                          .value = text(h),
                          .allowed = "a finite number above 0"});
    }
    if (options.improve_rounds < 0) {
        throw InputError({.what = "rounds of improvement",
                          .where = "options",
                          .value = std::to_string(options.improve_rounds),
                          .allowed = "0 or more"});
    }
    const Point<double> low = rounded<Real>(domain.low);
    const Point<double> high = rounded<Real>(domain.high);
    if (!is_finite(low) || !is_finite(high)) {
        throw InputError({.what = "a coordinate is not finite",
                          .where = "domain",
                          .value = text(domain.low) + " to " + text(domain.high),
                          .allowed = "finite coordinates"});
    }
    const double width = high.x() - low.x();
    const double height = high.y() - low.y();
    if (!(width > 0) || !(height > 0) || !std::isfinite(width * height)) {
        throw InputError({.what = "the rectangle is empty or out of range",
                          .where = "domain",
                          .value = text(domain.low) + " to " + text(domain.high),
                          .allowed = "low below high in x and y, and an area that is finite"});
    }
    if (h < least_initial_edge_length || h > 1 / least_initial_edge_length) {
        throw InputError({.what = "edge length is out of range",
                          .where = "options",
                          .value = text(h),
                          .allowed = text(least_initial_edge_length) + " to " +
                                     text(1 / least_initial_edge_length) +
                                     "; a UnitMap brings any scene there"});
    }
    if (h > std::min(width, height)) {
        throw InputError({.what = "edge length is larger than the domain",
                          .where = "options",
                          .value = text(h),
                          .allowed = "at most " + text(std::min(width, height))});
    }
    const double resolution = std::max(largest(low), largest(high)) *
                              static_cast<double>(std::numeric_limits<Real>::epsilon());
    if (h < least_steps * resolution) {
        throw InputError({.what = "edge length is below what coordinates of this size resolve",
                          .where = "options",
                          .value = text(h),
                          .allowed = "at least " + text(least_steps * resolution) +
                                     "; a UnitMap brings a scene near the origin"});
    }
    // An equilateral triangle has the area sqrt(3)/4 h^2.
    const double triangles = width / h * (height / h) / 0.43301270189221933;
    if (!(triangles <= most_triangles)) {
        throw InputError(
            {.what = "the complex would be absurdly large",
             .where = "options",
             .value = "edge length " + text(h) + ", about " + text(triangles) + " triangles",
             .allowed = "at most " + text(most_triangles) + " triangles"});
    }
    return fit_lattice(low, high, h);
}

void check_collinear(const std::vector<Point<double>>& points, std::size_t shape) {
    const Point<double>& a = points.front();
    const Point<double>* b = &a;
    for (const auto& point : points) {
        b = largest(point - a) > largest(*b - a) ? &point : b;
    }
    for (const auto& point : points) {
        if (orientation<double>(a, *b, point) != 0) {
            return;
        }
    }
    throw InputError({.what = "the outline encloses no area",
                      .where = shape_name(shape),
                      .value = std::to_string(points.size()) + " collinear vertices",
                      .allowed = "a simple polygon"});
}

void check_extent(const std::vector<Point<double>>& points, std::size_t shape,
                  const Lattice& lattice, double h) {
    Point<double> low = points.front();
    Point<double> high = points.front();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point<double>& p = points[i];
        const double margin = std::min({p.x() - lattice.low.x(), lattice.high.x() - p.x(),
                                        p.y() - lattice.low.y(), lattice.high.y() - p.y()});
        if (!(margin >= least_margin * h)) {
            throw InputError({.what = "the outline is not strictly inside the domain",
                              .where = vertex_name(shape, i),
                              .value = text(p),
                              .allowed = "a distance of at least " + text(least_margin * h) +
                                         " to the sides of " + text(lattice.low) + " to " +
                                         text(lattice.high)});
        }
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double side = (high - low).minCoeff();
    if (h > side) {
        throw InputError(
            {.what = "edge length is larger than the shape",
             .where = shape_name(shape),
             .value = text(h),
             .allowed = "at most " + text(side) + ", the smaller side of its bounding box"});
    }
}

// Rounds one shape and makes all checks that need no other shape, except for crossings.
template <class Real>
std::vector<Point<double>> check_shape(const Shape& shape, std::size_t index,
                                       const Lattice& lattice, double h) {
    const auto& outline = shape.outline;
    if (shape.phase == border_phase) {
        throw InputError({.what = "the phase is reserved",
                          .where = shape_name(index),
                          .value = std::to_string(shape.phase),
                          .allowed = "0 to 4294967294"});
    }
    if (outline.size() < 3) {
        throw InputError({.what = "the outline has too few vertices",
                          .where = shape_name(index),
                          .value = std::to_string(outline.size()),
                          .allowed = "3 or more"});
    }
    std::vector<Point<double>> points;
    points.reserve(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
        points.push_back(rounded<Real>(outline[i]));
        if (!is_finite(outline[i]) || !is_finite(points.back())) {
            throw InputError({.what = "a coordinate is not finite",
                              .where = vertex_name(index, i),
                              .value = text(outline[i]),
                              .allowed = "finite coordinates"});
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t j = i + 1 < points.size() ? i + 1 : 0;
        if (points[i] == points[j]) {
            const bool zero = outline[i] == outline[j];
            throw InputError(
                {.what = zero ? "the edge has no length"
                              : "vertices collide when rounded to the scalar of the complex",
                 .where = edge_name(index, i),
                 .value = text(outline[i]) + " to " + text(outline[j]),
                 .allowed = "distinct vertices; the first is not repeated at the end"});
        }
    }
    check_collinear(points, index);
    check_extent(points, index, lattice, h);
    return points;
}

// From the turn at the lowest of the leftmost vertices, which is convex in a simple polygon. If it
// is 0, the edges overlap, which the sweep reports.
bool is_counter_clockwise(const std::vector<Point<double>>& points) {
    const auto at =
        std::min_element(points.begin(), points.end(), [](const auto& a, const auto& b) {
            return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
        });
    const auto before = at == points.begin() ? std::prev(points.end()) : std::prev(at);
    const auto after = std::next(at) == points.end() ? points.begin() : std::next(at);
    return orientation<double>(*before, *at, *after) >= 0;
}

struct CutOutline {
    std::vector<Point<double>> points;
    std::vector<std::uint32_t> edge; // the edge of which a piece is part
};

// A length that is a whole number of target lengths, up to rounding, is cut into as many pieces.
constexpr double whole_number_slack = 1e-9;

double piece_count(const std::vector<Point<double>>& outline, std::size_t edge, double h) {
    const Point<double>& a = outline[edge];
    const Point<double>& b = outline[edge + 1 < outline.size() ? edge + 1 : 0];
    return std::max(1.0, std::ceil((b - a).norm() / h * (1 - whole_number_slack)));
}

// Counts pieces of the outline before rounding, so that float and double are cut alike.
template <class Real>
CutOutline cut(const std::vector<Point<double>>& given, const std::vector<Point<double>>& points,
               double h) {
    CutOutline result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point<double>& a = points[i];
        const Point<double>& b = points[i + 1 < points.size() ? i + 1 : 0];
        const auto pieces = static_cast<std::uint32_t>(piece_count(given, i, h));
        for (std::uint32_t k = 0; k < pieces; ++k) {
            const double fraction = static_cast<double>(k) / pieces;
            result.points.push_back(k == 0 ? a : rounded<Real>(a + fraction * (b - a)));
            result.edge.push_back(static_cast<std::uint32_t>(i));
        }
    }
    return result;
}

[[noreturn]] void refuse_contact(const Contact& contact, std::uint32_t edge,
                                 std::uint32_t other_edge) {
    const bool same = contact.polygon == contact.other_polygon;
    throw InputError(
        {.what = same ? "the outline crosses or touches itself" : "two outlines cross or touch",
         .where = edge_name(contact.polygon, edge),
         .value = "contact with " + edge_name(contact.other_polygon, other_edge),
         .allowed = "outlines that are simple and apart"});
}

std::vector<SweepPolygon> polygons_of(const std::vector<std::vector<Point<double>>>& outlines) {
    std::vector<SweepPolygon> polygons;
    for (const auto& points : outlines) {
        polygons.push_back({points, is_counter_clockwise(points)});
    }
    return polygons;
}

} // namespace

template <class Real>
CheckedInput check_input(const Rectangle& domain, std::span<const Shape> shapes,
                         const InitialOptions& options) {
    const double h = options.edge_length;
    CheckedInput input;
    input.lattice = check_domain<Real>(domain, options);
    std::vector<std::vector<Point<double>>> outlines;
    double pieces = 0;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        outlines.push_back(check_shape<Real>(shapes[k], k, input.lattice, h));
        for (std::size_t i = 0; i < shapes[k].outline.size(); ++i) {
            pieces += piece_count(shapes[k].outline, i, h);
        }
        if (pieces > most_triangles / 4) {
            throw InputError({.what = "the outlines would be cut into absurdly many pieces",
                              .where = shape_name(k),
                              .value = text(pieces),
                              .allowed = "at most " + text(most_triangles / 4)});
        }
    }
    const SweepResult result = sweep(polygons_of(outlines));
    if (result.contact) {
        refuse_contact(*result.contact, result.contact->edge, result.contact->other_edge);
    }
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const std::uint32_t parent = result.parent[k];
        const Phase around = parent == no_id ? exterior_phase : shapes[parent].phase;
        if (shapes[k].phase == around) {
            throw InputError({.what = "the shape has the phase of what is around it",
                              .where = shape_name(k),
                              .value = std::to_string(shapes[k].phase),
                              .allowed = "any other; phase 0 only in a shape of another phase"});
        }
    }
    // Rounding moves the vertices that cut an edge; they too must keep the outlines apart.
    std::vector<CutOutline> cuts;
    std::vector<SweepPolygon> polygons;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
        cuts.push_back(cut<Real>(shapes[k].outline, outlines[k], h));
    }
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        polygons.push_back({cuts[k].points, is_counter_clockwise(outlines[k])});
    }
    if (const auto contact = sweep(polygons).contact) {
        refuse_contact(*contact, cuts[contact->polygon].edge[contact->edge],
                       cuts[contact->other_polygon].edge[contact->other_edge]);
    }
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        if (!polygons[k].counter_clockwise) {
            std::reverse(cuts[k].points.begin(), cuts[k].points.end());
        }
        input.outlines.push_back({std::move(cuts[k].points), shapes[k].phase});
    }
    return input;
}

template CheckedInput check_input<double>(const Rectangle&, std::span<const Shape>,
                                          const InitialOptions&);
template CheckedInput check_input<float>(const Rectangle&, std::span<const Shape>,
                                         const InitialOptions&);

} // namespace dsc::initial
