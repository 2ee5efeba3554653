// SPDX-License-Identifier: MIT
// Simplices and simplex sets as in the thesis, section 8.2: a simplex is its vertices, a vertex is
// a number, and a simplex set is three std::set, one for each dimension.
#pragma once

#include "dsc/base/types.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <set>

namespace dsc::reference {

/// A 1-simplex <v0, v1>: its two vertices, the smaller number first.
struct EdgeKey {
    std::array<Vertex, 2> v;
    friend auto operator<=>(const EdgeKey&, const EdgeKey&) = default;
};

/// A 2-simplex <v0, v1, v2>: its three vertices in ascending order.
struct TriangleKey {
    std::array<Vertex, 3> v;
    friend auto operator<=>(const TriangleKey&, const TriangleKey&) = default;
};

inline EdgeKey edge_key(Vertex a, Vertex b) { return a < b ? EdgeKey{{a, b}} : EdgeKey{{b, a}}; }

inline TriangleKey triangle_key(Vertex a, Vertex b, Vertex c) {
    if (b < a)
        std::swap(a, b);
    if (c < b)
        std::swap(b, c);
    if (b < a)
        std::swap(a, b);
    return TriangleKey{{a, b, c}};
}

/// The three edges of a triangle; the i-th lies opposite to vertex i.
inline std::array<EdgeKey, 3> edges_of(const TriangleKey& t) {
    return {EdgeKey{{t.v[1], t.v[2]}}, EdgeKey{{t.v[0], t.v[2]}}, EdgeKey{{t.v[0], t.v[1]}}};
}

/// vert(face) is a subset of vert(sigma).
inline bool has_vertex(const EdgeKey& e, Vertex v) { return e.v[0] == v || e.v[1] == v; }
inline bool has_vertex(const TriangleKey& t, Vertex v) {
    return t.v[0] == v || t.v[1] == v || t.v[2] == v;
}

/// A set of simplices of any dimension.
struct SimplexSet {
    std::set<Vertex> vertices;
    std::set<EdgeKey> edges;
    std::set<TriangleKey> triangles;

    void insert(Vertex v) { vertices.insert(v); }
    void insert(const EdgeKey& e) { edges.insert(e); }
    void insert(const TriangleKey& t) { triangles.insert(t); }
    void insert(const SimplexSet& other) {
        vertices.insert(other.vertices.begin(), other.vertices.end());
        edges.insert(other.edges.begin(), other.edges.end());
        triangles.insert(other.triangles.begin(), other.triangles.end());
    }

    void erase(Vertex v) { vertices.erase(v); }
    void erase(const EdgeKey& e) { edges.erase(e); }
    void erase(const TriangleKey& t) { triangles.erase(t); }

    [[nodiscard]] bool contains(Vertex v) const { return vertices.contains(v); }
    [[nodiscard]] bool contains(const EdgeKey& e) const { return edges.contains(e); }
    [[nodiscard]] bool contains(const TriangleKey& t) const { return triangles.contains(t); }
    /// |Sigma| in the notation of the thesis.
    [[nodiscard]] std::size_t size() const {
        return vertices.size() + edges.size() + triangles.size();
    }

    friend bool operator==(const SimplexSet&, const SimplexSet&) = default;
};

/// Union.
inline SimplexSet operator|(SimplexSet a, const SimplexSet& b) {
    a.insert(b);
    return a;
}

/// Difference: the simplices in `a` that are not in `b`.
inline SimplexSet operator-(SimplexSet a, const SimplexSet& b) {
    std::erase_if(a.vertices, [&](Vertex v) { return b.contains(v); });
    std::erase_if(a.edges, [&](const EdgeKey& e) { return b.contains(e); });
    std::erase_if(a.triangles, [&](const TriangleKey& t) { return b.contains(t); });
    return a;
}

/// Intersection.
inline SimplexSet operator&(SimplexSet a, const SimplexSet& b) {
    std::erase_if(a.vertices, [&](Vertex v) { return !b.contains(v); });
    std::erase_if(a.edges, [&](const EdgeKey& e) { return !b.contains(e); });
    std::erase_if(a.triangles, [&](const TriangleKey& t) { return !b.contains(t); });
    return a;
}

/// The algorithms of section 7 say "rename vertices in V to v1, v2, ...": here in ascending order.
template <std::size_t N>
std::array<Vertex, N> rename(const std::set<Vertex>& set) {
    assert(set.size() == N);
    std::array<Vertex, N> names;
    std::copy_n(set.begin(), N, names.begin());
    return names;
}

} // namespace dsc::reference
