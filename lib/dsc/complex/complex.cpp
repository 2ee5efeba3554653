// SPDX-License-Identifier: MIT
#include "dsc/complex/complex.h"

#include "dsc/base/error.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/records.h"
#include "dsc/complex/rewire.h"

#include <algorithm>
#include <string>
#include <utility>

namespace dsc {

namespace {

constexpr TriangleRecord border_record{
    {0, 0, 0}, {border_corner, border_corner, border_corner}, border_phase, 0};
constexpr TriangleRecord dead_record{{no_id, no_id, no_id}, border_record.n, border_phase, 0};

[[noreturn]] void refuse_to_grow(const char* of_what, std::uint32_t number, std::uint32_t max) {
    throw InputError({.what = "the mesh has reached its largest size",
                      .where = "Complex",
                      .value = std::to_string(number) + " " + of_what,
                      .allowed = "at most " + std::to_string(max)});
}

} // namespace

void InUse::expect_free() const {
    if (by_a_simulation) {
        throw InputError({.what = "this complex already belongs to another Simulation",
                          .where = "Simulation",
                          .value = "a second Simulation",
                          .allowed = "one Simulation at a time: destroy the other one first"});
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
        journal = empty.journal; // tells the readers that the mesh was replaced
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

// Appends a record; `resize` makes its attributes. An exception leaves both arrays unchanged.
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

// New ids go to the front of the pool, because ids are taken from its back.
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

} // namespace dsc
