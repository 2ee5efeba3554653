// SPDX-License-Identifier: MIT
#include "thesis/sets/insertion_removal.h"

#include "dsc/base/error.h"
#include "dsc/base/types.h"
#include "dsc/complex/ranges.h"
#include "dsc/complex/rewire.h"
#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace dsc {

namespace {

[[noreturn]] void refuse_triangle(const std::string& what, const std::array<std::uint32_t, 3>& v,
                                  const std::string& allowed) {
    throw InputError({.what = what,
                      .where = "insert_triangle",
                      .value = "(" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
                               std::to_string(v[2]) + ")",
                      .allowed = allowed});
}

// The corners opposite to the half-edges v[i+2] -> v[i+1], which will be the neighbours of the new
// triangle. Throws if one of its own half-edges is taken.
template <class Real>
std::array<Corner, 3> find_neighbours(const Complex<Real>& complex,
                                      const std::array<std::uint32_t, 3>& v) {
    std::array<Corner, 3> found{border_corner, border_corner, border_corner};
    const auto used = std::count_if(
        v.begin(), v.end(), [&](std::uint32_t id) { return complex.vertices[id].corner != no_id; });
    if (used < 2) {
        return found; // an edge that exists has two vertices in use
    }
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        const auto& w = complex.triangles[t].v;
        if (w[0] == no_id) {
            continue;
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t from = v[(i + 1) % 3];
            const std::uint32_t to = v[(i + 2) % 3];
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t other_from = w[(k + 1) % 3];
                const std::uint32_t other_to = w[(k + 2) % 3];
                if (other_from == from && other_to == to) {
                    const bool full = !is_border(complex.triangles[t].n[k]);
                    refuse_triangle(full ? "an edge has two triangles already"
                                         : "the triangle overlaps the one at its edge",
                                    v, "edges that are free on the side of the new triangle");
                }
                if (other_from == to && other_to == from) {
                    found[i] = corner_of(t, k);
                }
            }
        }
    }
    return found;
}

} // namespace

template <class Real>
Vertex insert_vertex(Complex<Real>& complex, const Point<Real>& p) {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y())) {
        std::ostringstream value;
        value << '(' << p.x() << ", " << p.y() << ')';
        throw InputError({.what = "a coordinate is not finite",
                          .where = "insert_vertex",
                          .value = value.str(),
                          .allowed = "finite coordinates"});
    }
    const std::uint32_t id = complex.take_vertex(complex.ids);
    if (id == no_id) {
        throw InputError({.what = "no free id",
                          .where = "insert_vertex",
                          .value = "an empty pool that may not grow",
                          .allowed = "a pool with free ids, or one that may grow"});
    }
    complex.attributes.reset_vertex(id);
    complex.vertices[id].x = p.x();
    complex.vertices[id].y = p.y();
    rewire::note(complex.journal, [&] {
        return Edit{.kind = EditKind::insert_vertex,
                    .vertex = Vertex{id},
                    .x = static_cast<double>(p.x()),
                    .y = static_cast<double>(p.y())};
    });
    complex.attributes.failure.rethrow();
    return Vertex{id};
}

template <class Real>
Triangle insert_triangle(Complex<Real>& complex, Vertex a, Vertex b, Vertex c, Phase phase) {
    std::array<std::uint32_t, 3> v{a.id, b.id, c.id};
    for (const std::uint32_t id : v) {
        if (!complex.is_alive(Vertex{id})) {
            refuse_triangle("a vertex is not alive", v, "living vertices");
        }
    }
    if (a == b || b == c || c == a) {
        refuse_triangle("a vertex is named twice", v, "three distinct vertices");
    }
    if (phase == border_phase) {
        throw InputError({.what = "a phase is reserved",
                          .where = "insert_triangle",
                          .value = std::to_string(phase),
                          .allowed = "0 to 4294967294"});
    }
    const int sign =
        dsc::orientation(complex.position(a), complex.position(b), complex.position(c));
    if (sign == 0) {
        refuse_triangle("the triangle is degenerate", v, "a positive area");
    }
    if (sign < 0) {
        std::swap(v[1], v[2]);
    }
    const std::array<Corner, 3> neighbours = find_neighbours(complex, v);
    const std::uint32_t id = complex.take_triangle(complex.ids);
    if (id == no_id) {
        throw InputError({.what = "no free id",
                          .where = "insert_triangle",
                          .value = "an empty pool that may not grow",
                          .allowed = "a pool with free ids, or one that may grow"});
    }
    complex.triangles[id] = TriangleRecord{v, neighbours, phase, 0};
    complex.attributes.reset_triangle(id);
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner here = corner_of(id, i);
        const Corner across = neighbours[i];
        if (is_border(across)) {
            complex.attributes.reset_edge(here);
        } else {
            complex.triangles[triangle_of(across)].n[index_of(across)] = here;
            complex.attributes.copy_edge(here, across);
        }
        if (complex.vertices[v[i]].corner == no_id) {
            complex.vertices[v[i]].corner = here;
        }
    }
    rewire::note(complex.journal, [&] {
        return Edit{.kind = EditKind::insert_triangle,
                    .corner = corner_of(id, 0),
                    .ends = {Vertex{v[0]}, Vertex{v[1]}},
                    .apexes = {Vertex{v[2]}, Vertex{}},
                    .made = {phase, no_id}};
    });
    complex.attributes.failure.rethrow();
    return Triangle{id};
}

namespace {

// The triangles to remove: those named, those of named edges, those that contain a named vertex.
// The last are found by a sweep: rotation would miss the second fan of a non-manifold vertex.
template <class Real>
std::vector<Triangle> doomed_triangles(const Complex<Real>& complex, const SimplexSet& set) {
    std::vector<Triangle> doomed;
    for (const Triangle t : set.triangles()) {
        if (complex.is_alive(t)) {
            doomed.push_back(t);
        }
    }
    for (const Edge e : set.edges()) {
        if (!complex.is_alive(e)) {
            continue;
        }
        doomed.push_back(Triangle{triangle_of(e.id)});
        if (!is_border(complex.twin(e.id))) {
            doomed.push_back(Triangle{triangle_of(complex.twin(e.id))});
        }
    }
    if (!set.vertices().empty()) {
        for (const Triangle t : triangles(complex)) {
            for (const std::uint32_t v : complex.triangles[t.id].v) {
                if (set.contains(Vertex{v})) {
                    doomed.push_back(t);
                    break;
                }
            }
        }
    }
    return SimplexSet({}, {}, std::move(doomed)).triangles();
}

// Unlinks the triangle and gives its vertices a corner in a neighbouring triangle, if there is one.
template <class Real>
void unlink(Complex<Real>& complex, Triangle t, std::vector<std::uint32_t>& orphans) {
    const auto record = complex.triangles[t.id];
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner across = record.n[i];
        if (!is_border(across)) {
            complex.triangles[triangle_of(across)].n[index_of(across)] = border_corner;
        }
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
        auto& vertex = complex.vertices[record.v[i]];
        if (vertex.corner != corner_of(t.id, i)) {
            continue;
        }
        const Corner after = record.n[(i + 1) % 3]; // across the edge where the triangle ends
        const Corner before = record.n[(i + 2) % 3];
        if (!is_border(after)) {
            vertex.corner = next(after);
        } else if (!is_border(before)) {
            vertex.corner = prev(before);
        } else {
            vertex.corner = no_id;
            orphans.push_back(record.v[i]);
        }
    }
}

// A vertex that lost the fan its corner was in may have another one.
template <class Real>
void adopt(Complex<Real>& complex) {
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            auto& vertex = complex.vertices[complex.triangles[t.id].v[i]];
            if (vertex.corner == no_id) {
                vertex.corner = corner_of(t.id, i);
            }
        }
    }
}

} // namespace

template <class Real>
std::size_t remove(Complex<Real>& complex, const SimplexSet& set) {
    const std::vector<Triangle> doomed = doomed_triangles(complex, set);
    std::vector<std::uint32_t> orphans;
    for (const Triangle t : doomed) {
        rewire::note(complex.journal, [&] {
            const auto& v = complex.triangles[t.id].v;
            return Edit{.kind = EditKind::remove_triangle,
                        .corner = corner_of(t.id, 0),
                        .ends = {Vertex{v[0]}, Vertex{v[1]}},
                        .apexes = {Vertex{v[2]}, Vertex{}}};
        });
        unlink(complex, t, orphans);
        complex.give_triangle(complex.ids, t.id);
    }
    std::erase_if(orphans, [&](std::uint32_t v) { return set.contains(Vertex{v}); });
    if (!orphans.empty()) {
        adopt(complex);
    }
    for (const Vertex v : set.vertices()) {
        if (complex.is_alive(v)) {
            complex.give_vertex(complex.ids, v.id);
            rewire::note(complex.journal,
                         [&] { return Edit{.kind = EditKind::remove_vertex, .vertex = v}; });
        }
    }
    return doomed.size();
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Vertex insert_vertex(Complex<Real>&, const Point<Real>&);                             \
    template Triangle insert_triangle(Complex<Real>&, Vertex, Vertex, Vertex, Phase);              \
    template std::size_t remove(Complex<Real>&, const SimplexSet&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
