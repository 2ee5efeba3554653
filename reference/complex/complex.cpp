// SPDX-License-Identifier: MIT
#include "reference/complex/complex.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dsc::reference {

Vertex Complex::insert(const Point<double>& coord) {
    Vertex v;
    if (free_.empty()) {
        v = Vertex{static_cast<std::uint32_t>(coords_.size())};
        coords_.push_back(coord);
        edges_at_.emplace_back();
        triangles_at_.emplace_back();
    } else {
        v = free_.back();
        free_.pop_back();
        coords_[v.id] = coord;
    }
    vertices_.insert(v);
    return v;
}

TriangleKey Complex::insert(Vertex a, Vertex b, Vertex c) {
    const TriangleKey t = triangle_key(a, b, c);
    // Section 8.2: insertion accepts the vertices in any order, and the mesh orients them
    // counter-clockwise.
    if (dsc::orientation(coord(a), coord(b), coord(c)) < 0) {
        std::swap(b, c);
    }
    triangles_[t] = {a, b, c};
    phases_[t] = exterior_phase;
    for (const EdgeKey& e : edges_of(t)) {
        edges_[e].insert(t);
        edges_at_[e.v[0].id].insert(e);
        edges_at_[e.v[1].id].insert(e);
    }
    for (Vertex v : t.v) {
        triangles_at_[v.id].insert(t);
    }
    return t;
}

void Complex::remove(Vertex v) {
    if (vertices_.erase(v) == 0) {
        return;
    }
    edges_at_[v.id].clear();
    triangles_at_[v.id].clear();
    locked.erase(v);
    boundary_features.erase(v);
    free_.push_back(v);
}

void Complex::remove(const EdgeKey& e) {
    if (edges_.erase(e) == 0) {
        return;
    }
    for (Vertex v : e.v) {
        edges_at_[v.id].erase(e);
    }
}

void Complex::remove(const TriangleKey& t) {
    if (triangles_.erase(t) == 0) {
        return;
    }
    phases_.erase(t);
    for (const EdgeKey& e : edges_of(t)) {
        if (const auto found = edges_.find(e); found != edges_.end()) {
            found->second.erase(t);
        }
    }
    for (Vertex v : t.v) {
        triangles_at_[v.id].erase(t);
    }
}

void Complex::remove(const SimplexSet& set) {
    for (const TriangleKey& t : set.triangles)
        remove(t);
    for (const EdgeKey& e : set.edges)
        remove(e);
    for (Vertex v : set.vertices)
        remove(v);
}

int Complex::orientation(const TriangleKey& t) const {
    const OrientedTriangle& o = oriented(t);
    return dsc::orientation(coord(o[0]), coord(o[1]), coord(o[2]));
}

bool Complex::is_submesh_boundary(Vertex v) const { return submesh_boundary_vertices.contains(v); }

bool Complex::is_submesh_boundary(const EdgeKey& e) const {
    return submesh_boundary_edges.contains(e);
}

bool Complex::is_interface(const EdgeKey& e) const { return is_interface(e, triangles_at(e)); }

bool Complex::is_interface(const EdgeKey& e, const std::set<TriangleKey>& T) const {
    if (T.size() == 2) {
        return phase(*T.begin()) != phase(*T.rbegin());
    }
    // Section 8.6: across a submesh boundary the phase is unknown, and the edge is locked anyway;
    // at the mesh boundary all phases but the exterior have an interface (figure 8.3).
    return T.size() == 1 && !is_submesh_boundary(e) && phase(*T.begin()) != exterior_phase;
}

bool Complex::is_interface(Vertex v) const {
    return std::ranges::any_of(edges_at(v), [&](const EdgeKey& e) { return is_interface(e); });
}

SimplexSet Complex::interface() const {
    SimplexSet I;
    for (const auto& [e, T] : edges_) {
        if (is_interface(e, T)) {
            I.insert(e);
            I.vertices.insert(e.v.begin(), e.v.end());
        }
    }
    return I;
}

bool Complex::is_boundary(const EdgeKey& e) const {
    return triangles_at(e).size() == 1 && !is_submesh_boundary(e);
}

bool Complex::is_boundary(Vertex v) const {
    return std::ranges::any_of(edges_at(v), [&](const EdgeKey& e) { return is_boundary(e); });
}

std::optional<std::array<Vertex, 2>> Complex::straight_boundary(Vertex v) const {
    std::set<Vertex> neighbours;
    for (const EdgeKey& e : edges_at(v)) {
        if (is_boundary(e))
            neighbours.insert(e.v[0] == v ? e.v[1] : e.v[0]);
    }
    if (neighbours.size() != 2)
        return std::nullopt;
    const auto [a, b] = rename<2>(neighbours);
    if (dsc::orientation(coord(a), coord(v), coord(b)) != 0)
        return std::nullopt;
    return std::array{a, b};
}

bool Complex::is_constrained(const EdgeKey& e) const {
    return is_boundary(e) || is_interface(e) || submesh_boundary_interface.contains(e);
}

Complex make_complex(std::span<const Point<double>> points,
                     std::span<const std::array<std::uint32_t, 3>> triangles,
                     std::span<const Phase> phases) {
    const std::string where = "reference::make_complex";
    if (phases.size() != triangles.size()) {
        throw InputError(
            {.what = "wrong number of phases",
             .where = where,
             .value = std::to_string(phases.size()),
             .allowed = "one for each of the " + std::to_string(triangles.size()) + " triangles"});
    }
    Complex K;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(points[i].x()) || !std::isfinite(points[i].y())) {
            throw InputError(
                {.what = "a coordinate of point " + std::to_string(i) + " is not finite",
                 .where = where,
                 .value = std::to_string(points[i].x()) + ", " + std::to_string(points[i].y()),
                 .allowed = "finite numbers"});
        }
        K.insert(points[i]);
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto [a, b, c] = triangles[i];
        const std::string name = "triangle " + std::to_string(i);
        const std::string value =
            std::to_string(a) + ", " + std::to_string(b) + ", " + std::to_string(c);
        if (a >= points.size() || b >= points.size() || c >= points.size()) {
            throw InputError({.what = "a vertex of " + name + " does not exist",
                              .where = where,
                              .value = value,
                              .allowed = "numbers below " + std::to_string(points.size())});
        }
        if (dsc::orientation(points[a], points[b], points[c]) == 0) {
            throw InputError({.what = name + " has no area",
                              .where = where,
                              .value = value,
                              .allowed = "three vertices that are not collinear"});
        }
        const TriangleKey t = K.insert(Vertex{a}, Vertex{b}, Vertex{c});
        K.set_phase(t, phases[i]);
        for (const EdgeKey& e : edges_of(t)) {
            if (K.triangles_at(e).size() > 2) {
                throw InputError({.what = "an edge of " + name + " has more than two triangles",
                                  .where = where,
                                  .value = value,
                                  .allowed = "a manifold with boundary"});
            }
        }
    }
    return K;
}

Arrays to_arrays(const Complex& K) {
    Arrays arrays;
    VertexAttribute<std::uint32_t> number(K.vertex_bound(), no_id);
    arrays.points.reserve(K.vertices().size());
    for (Vertex v : K.vertices()) {
        number[v.id] = static_cast<std::uint32_t>(arrays.points.size());
        arrays.points.push_back(K.coord(v));
    }
    arrays.triangles.reserve(K.triangles().size());
    arrays.phases.reserve(K.triangles().size());
    for (const auto& [t, o] : K.triangles()) {
        arrays.triangles.push_back({number[o[0].id], number[o[1].id], number[o[2].id]});
        arrays.phases.push_back(K.phase(t));
    }
    return arrays;
}

} // namespace dsc::reference
