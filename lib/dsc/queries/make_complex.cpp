// SPDX-License-Identifier: MIT
// `make_complex`, which is declared with the complex but defined here because it calls the
// validator.
#include "dsc/base/error.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/complex.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/side.h"
#include "dsc/queries/validate.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dsc {

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& value,
                         const std::string& allowed) {
    throw InputError({.what = what, .where = "make_complex", .value = value, .allowed = allowed});
}

struct HalfEdge {
    std::uint64_t key; // smaller vertex, larger vertex
    Corner corner;
};

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
}

// Sorting half-edges by their end points pairs the twins without a hash table.
template <class Real>
void link_twins(Complex<Real>& complex) {
    std::vector<HalfEdge> half_edges;
    half_edges.reserve(3 * complex.triangles.size());
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t, i);
            half_edges.push_back({edge_key(complex.vertex(next(c)), complex.vertex(prev(c))), c});
        }
    }
    std::sort(half_edges.begin(), half_edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return a.key != b.key ? a.key < b.key : a.corner < b.corner;
    });
    for (std::size_t i = 0; i + 1 < half_edges.size(); ++i) {
        const HalfEdge& a = half_edges[i];
        const HalfEdge& b = half_edges[i + 1];
        if (a.key != b.key) {
            continue;
        }
        const std::string name =
            std::to_string(a.key >> 32U) + "-" + std::to_string(a.key & 0xffffffffU);
        if (i + 2 < half_edges.size() && half_edges[i + 2].key == a.key) {
            refuse("an edge has more than two triangles", "edge " + name, "one or two triangles");
        }
        if (complex.vertex(next(a.corner)) == complex.vertex(next(b.corner))) {
            refuse("two triangles overlap at an edge", "edge " + name,
                   "triangles on either side of it");
        }
        complex.triangles[triangle_of(a.corner)].n[index_of(a.corner)] = b.corner;
        complex.triangles[triangle_of(b.corner)].n[index_of(b.corner)] = a.corner;
        ++i;
    }
}

// A vertex is manifold if rotating about it visits every triangle that names it (thesis, section
// 3.2).
template <class Real>
void check_manifold(const Complex<Real>& complex) {
    std::vector<std::uint32_t> named(complex.vertex_bound(), 0);
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        for (const std::uint32_t v : complex.triangles[t].v) {
            ++named[v];
        }
    }
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (complex.vertices[v].corner == no_id) {
            continue;
        }
        std::uint32_t met = 0;
        for_each_corner(complex, Vertex{v}, [&](Corner) { ++met; });
        if (met != named[v]) {
            refuse("a vertex is not manifold", "vertex " + std::to_string(v),
                   "triangles that form one disc or half disc about it");
        }
    }
}

// Marks the sharp turns of the domain boundary.
template <class Real>
void mark_boundary_features(Complex<Real>& complex) {
    std::vector<std::uint32_t> after(complex.vertex_bound(), no_id); // with the domain on the left
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (const Corner c = corner_of(t, i); is_border(complex.twin(c))) {
                after[complex.vertex(next(c))] = complex.vertex(prev(c));
            }
        }
    }
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (const std::uint32_t at = after[v]; at != no_id) {
            const Side side =
                side_at<Real>(complex.position(Vertex{v}), complex.position(Vertex{at}),
                              complex.position(Vertex{after[at]}), true);
            complex.set_boundary_feature(Vertex{at}, side == Side::feature);
        }
    }
}

} // namespace

template <class Real>
Complex<Real> make_complex(std::span<const Point<Real>> points,
                           std::span<const std::array<std::uint32_t, 3>> triangles,
                           std::span<const Phase> phases) {
    if (phases.size() != triangles.size()) {
        refuse("phases do not match triangles", std::to_string(phases.size()) + " phases",
               std::to_string(triangles.size()) + ", one per triangle");
    }
    if (points.size() >= no_id) {
        refuse("too many points", std::to_string(points.size()),
               "at most " + std::to_string(no_id - 1));
    }
    if (triangles.size() + 1 >= triangle_limit) {
        refuse("too many triangles", std::to_string(triangles.size()),
               "at most " + std::to_string(triangle_limit - 2));
    }
    Complex<Real> complex;
    complex.reserve(points.size(), triangles.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(points[i].x()) || !std::isfinite(points[i].y())) {
            refuse("a coordinate is not finite", "point " + std::to_string(i),
                   "finite coordinates");
        }
        complex.vertices.push_back({points[i].x(), points[i].y(), no_id, 0, 0, no_id});
    }
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        std::array<std::uint32_t, 3> v = triangles[t];
        for (const std::uint32_t index : v) {
            if (index >= points.size()) {
                refuse("a vertex index is out of range", std::to_string(index),
                       "0 to " + std::to_string(points.size()) + " - 1");
            }
        }
        if (phases[t] == border_phase) {
            refuse("a phase is reserved", std::to_string(phases[t]), "0 to 4294967294");
        }
        const int sign = orientation(points[v[0]], points[v[1]], points[v[2]]);
        if (sign == 0) {
            refuse("a triangle is degenerate", "triangle " + std::to_string(t), "a positive area");
        }
        if (sign < 0) {
            std::swap(v[1], v[2]);
        }
        const auto id = static_cast<std::uint32_t>(complex.triangles.size());
        complex.triangles.push_back(
            {v, {border_corner, border_corner, border_corner}, phases[t], 0});
        for (std::uint32_t i = 0; i < 3; ++i) {
            complex.vertices[v[i]].corner = corner_of(id, i);
        }
    }
    link_twins(complex);
    check_manifold(complex);
    complex.attributes.resize_vertices(complex.vertices.size());
    complex.attributes.resize_triangles(complex.triangles.size());
    if (const ValidationReport report = validate(complex); !report.ok()) {
        refuse("the triangles overlap", report.problem, "triangles that lie side by side");
    }
    mark_boundary_features(complex);
    return complex;
}

template Complex<double> make_complex(std::span<const Point<double>>,
                                      std::span<const std::array<std::uint32_t, 3>>,
                                      std::span<const Phase>);
template Complex<float> make_complex(std::span<const Point<float>>,
                                     std::span<const std::array<std::uint32_t, 3>>,
                                     std::span<const Phase>);

} // namespace dsc
