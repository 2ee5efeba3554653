// SPDX-License-Identifier: MIT
#include "dsc/initial/input/input_check.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/input/cutting.h"
#include "dsc/initial/input/outline_sweep.h"
#include "dsc/initial/input/text.h"

#include <algorithm>
#include <string>

namespace dsc::initial {

namespace {

std::string shape_name(std::size_t shape) { return "shape " + std::to_string(shape); }

std::string vertex_name(std::size_t shape, std::size_t vertex) {
    return shape_name(shape) + ", vertex " + std::to_string(vertex);
}

std::string shape_edge_name(std::size_t shape, std::size_t edge) {
    return shape_name(shape) + ", edge " + std::to_string(edge);
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
        if (!(distance_to_sides(lattice, p) >= least_margin * h)) {
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
                 .where = shape_edge_name(index, i),
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

double pieces_of_edge(const std::vector<Point<double>>& outline, std::size_t edge, double h) {
    return piece_count(outline[edge], outline[edge + 1 < outline.size() ? edge + 1 : 0], h);
}

// Counts pieces of the outline before rounding, so that float and double are cut alike.
template <class Real>
CutOutline cut(const std::vector<Point<double>>& given, const std::vector<Point<double>>& points,
               double h) {
    CutOutline result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point<double>& a = points[i];
        const Point<double>& b = points[i + 1 < points.size() ? i + 1 : 0];
        const auto pieces = static_cast<std::uint32_t>(pieces_of_edge(given, i, h));
        for (std::uint32_t k = 0; k < pieces; ++k) {
            result.points.push_back(cut_point<Real>(a, b, k, pieces));
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
         .where = shape_edge_name(contact.polygon, edge),
         .value = "contact with " + shape_edge_name(contact.other_polygon, other_edge),
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
            pieces += pieces_of_edge(shapes[k].outline, i, h);
        }
        if (pieces > most_pieces) {
            throw InputError({.what = "the outlines would be cut into absurdly many pieces",
                              .where = shape_name(k),
                              .value = text(pieces),
                              .allowed = "at most " + text(most_pieces)});
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
        cuts[k].points.push_back(cuts[k].points.front());
        input.outlines.push_back({std::move(cuts[k].points), shapes[k].phase});
    }
    return input;
}

template CheckedInput check_input<double>(const Rectangle&, std::span<const Shape>,
                                          const InitialOptions&);
template CheckedInput check_input<float>(const Rectangle&, std::span<const Shape>,
                                         const InitialOptions&);

} // namespace dsc::initial
