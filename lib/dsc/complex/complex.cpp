// SPDX-License-Identifier: MIT
#include "dsc/complex/complex.h"

#include "dsc/base/error.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/rewire.h"
#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace dsc {

namespace {

constexpr TriangleRecord border_record{
    {0, 0, 0}, {border_corner, border_corner, border_corner}, border_phase, 0};
constexpr TriangleRecord dead_record{{no_id, no_id, no_id}, border_record.n, border_phase, 0};

[[noreturn]] void refuse(const std::string& what, const std::string& value,
                         const std::string& allowed) {
    throw InputError({.what = what, .where = "make_complex", .value = value, .allowed = allowed});
}

[[noreturn]] void refuse_to_grow(const char* of_what, std::uint32_t number, std::uint32_t most) {
    throw InputError({.what = "the mesh has no ids left",
                      .where = "Complex",
                      .value = std::to_string(number) + " " + of_what,
                      .allowed = "at most " + std::to_string(most)});
}

} // namespace

void InUse::expect_free() const {
    if (by_a_simulation) {
        throw InputError({.what = "a complex that another simulation works on",
                          .where = "Simulation",
                          .value = "a second simulation",
                          .allowed = "one at a time: the first must be destroyed before"});
    }
}

template <class Real>
Complex<Real>::Complex() : triangles{border_record} {
    attributes.resize_triangles(1);
}

template <class Real>
Complex<Real>::Complex(Complex&& other) noexcept : Complex() {
    *this = std::move(other);
}

template <class Real>
Complex<Real>& Complex<Real>::operator=(const Complex& other) {
    return this == &other ? *this : *this = Complex(other);
}

template <class Real>
Complex<Real>& Complex<Real>::operator=(Complex&& other) noexcept {
    if (this != &other) {
        Complex empty;
        journal = empty.journal; // tells the readers that another mesh is there
        other.journal = empty.journal;
        attributes = std::exchange(other.attributes, std::move(empty.attributes));
        vertices = std::exchange(other.vertices, {});
        triangles = std::exchange(other.triangles, std::move(empty.triangles));
        ids = std::move(other.ids);
    }
    return *this;
}

template <class Real>
std::uint32_t Complex<Real>::vertex_count() const {
    return vertex_bound() - ids.vertex_total();
}

template <class Real>
std::uint32_t Complex<Real>::triangle_count() const {
    return triangle_bound() - 1 - ids.triangle_total();
}

template <class Real>
Corner Complex<Real>::find_half_edge(Vertex a, Vertex b) const {
    const Corner c = find_corner(*this, a, [&](Corner at) { return vertex(next(at)) == b.id; });
    return c == no_id ? no_id : prev(c);
}

template <class Real>
Edge Complex<Real>::find_edge(Vertex a, Vertex b) const {
    Corner c = find_half_edge(a, b);
    if (c == no_id) {
        c = find_half_edge(b, a);
    }
    return c == no_id ? Edge{} : edge(c);
}

template <class Real>
void Complex<Real>::set_position(Vertex v, const Point<Real>& p) {
    rewire::move(*this, journal, v.id, p.x(), p.y(), MoveReason::application);
}

template <class Real>
void Complex<Real>::set_phase(Triangle t, Phase phase) {
    rewire::relabel(*this, journal, t, phase);
}

namespace {

// Appends a record; `resize` makes its attributes. An exception leaves both as they were.
template <class Record, class Resize>
void append(std::vector<Record>& records, const Record& record, Resize resize) {
    records.push_back(record);
    try {
        resize(records.size());
    } catch (...) {
        records.pop_back();
        resize(records.size());
        throw;
    }
}

} // namespace

// New ids go to the end of the pool that is taken from last.
template <class Real>
void Complex<Real>::grow(IdPool& pool, std::size_t vertex_total, std::size_t triangle_total) {
    while (pool.vertices.size() < vertex_total) {
        const std::uint32_t id = vertex_bound();
        if (id + 1 >= no_id) {
            refuse_to_grow("vertices", id, no_id - 1);
        }
        pool.vertices.reserve(vertex_total);
        append(vertices, {0, 0, no_id, vertex_dead, 0, no_id},
               [this](std::size_t size) { attributes.resize_vertices(size); });
        pool.vertices.insert(pool.vertices.begin(), id);
    }
    while (pool.triangles.size() < triangle_total) {
        const std::uint32_t id = triangle_bound();
        if (id + 1 >= triangle_limit) {
            refuse_to_grow("triangles", id - 1, triangle_limit - 2);
        }
        pool.triangles.reserve(triangle_total);
        append(triangles, dead_record,
               [this](std::size_t size) { attributes.resize_triangles(size); });
        pool.triangles.insert(pool.triangles.begin(), id);
    }
}

template <class Real>
std::uint32_t Complex<Real>::take_vertex(IdPool& pool) {
    if (!have_ids(pool, 1, 0)) {
        return no_id;
    }
    const std::uint32_t id = pool.vertices.back();
    pool.vertices.pop_back();
    vertices[id] = VertexRecord<Real>{0, 0, no_id, 0, 0, no_id};
    return id;
}

template <class Real>
std::uint32_t Complex<Real>::take_triangle(IdPool& pool) {
    if (!have_ids(pool, 0, 1)) {
        return no_id;
    }
    const std::uint32_t id = pool.triangles.back();
    pool.triangles.pop_back();
    return id;
}

template <class Real>
void Complex<Real>::give_vertex(IdPool& pool, std::uint32_t id) {
    vertices[id].flags = vertex_dead;
    vertices[id].corner = no_id;
    pool.vertices.push_back(id);
}

template <class Real>
void Complex<Real>::give_triangle(IdPool& pool, std::uint32_t id) {
    triangles[id].v = {no_id, no_id, no_id};
    pool.triangles.push_back(id);
}

template <class Real>
void Complex<Real>::reserve(std::size_t vertex_total, std::size_t triangle_total) {
    vertices.reserve(vertex_total);
    triangles.reserve(triangle_total + 1);
    attributes.reserve(vertex_total, triangle_total + 1);
}

template class Complex<double>;
template class Complex<float>;

namespace {

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
    return complex;
}

template Complex<double> make_complex(std::span<const Point<double>>,
                                      std::span<const std::array<std::uint32_t, 3>>,
                                      std::span<const Phase>);
template Complex<float> make_complex(std::span<const Point<float>>,
                                     std::span<const std::array<std::uint32_t, 3>>,
                                     std::span<const Phase>);

} // namespace dsc
