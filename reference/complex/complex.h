// SPDX-License-Identifier: MIT
// The simplicial complex K of the literal method, with the mesh functions of the thesis,
// section 4.1, the attribute vectors of section 8.3 and the derived interface and boundaries of
// section 8.6.
#pragma once

#include "dsc/base/types.h"
#include "reference/complex/simplex.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace dsc::reference {

/// Attribute vectors (thesis, section 8.3): a std::vector by the number of the vertex, std::map for
/// the others.
template <class Value>
using VertexAttribute = std::vector<Value>;
template <class Value>
using EdgeAttribute = std::map<EdgeKey, Value>;
template <class Value>
using TriangleAttribute = std::map<TriangleKey, Value>;

/// A triangle [v0, v1, v2] in the stored order: counter-clockwise when inserted.
using OrientedTriangle = std::array<Vertex, 3>;

class Complex {
public:
    // --- mesh functions (thesis, section 4.1) ----------------------------------------------------
    /// Insertion of a 0-simplex. Numbers of removed vertices are reused.
    Vertex insert(const Point<double>& coord);
    /// Insertion of a 2-simplex and its boundary, in any orientation. Its phase is the exterior
    /// until `set_phase`.
    TriangleKey insert(Vertex a, Vertex b, Vertex c);
    /// Removal of one simplex only. Does nothing if it does not exist.
    void remove(Vertex v);
    void remove(const EdgeKey& e);
    void remove(const TriangleKey& t);
    /// Removal of all simplices in the set.
    void remove(const SimplexSet& set);

    /// +1 if the triangle is as it was inserted, -1 if inverted, 0 if it has no area. Exact.
    [[nodiscard]] int orientation(const TriangleKey& t) const;

    [[nodiscard]] bool is_submesh_boundary(Vertex v) const;
    [[nodiscard]] bool is_submesh_boundary(const EdgeKey& e) const;
    [[nodiscard]] bool is_interface(Vertex v) const;
    [[nodiscard]] bool is_interface(const EdgeKey& e) const;
    /// Interface(K): the interface edges and their vertices. A sweep over all edges.
    [[nodiscard]] SimplexSet interface() const;
    [[nodiscard]] bool is_boundary(Vertex v) const;
    [[nodiscard]] bool is_boundary(const EdgeKey& e) const;
    /// The two neighbours of `v` along the mesh boundary if it runs exactly straight through `v`;
    /// empty in a corner, or off the boundary.
    [[nodiscard]] std::optional<std::array<Vertex, 2>> straight_boundary(Vertex v) const;
    /// Whether the edge is on the interface (on the submesh boundary, too) or on the domain
    /// boundary.
    [[nodiscard]] bool is_constrained(const EdgeKey& e) const;
    [[nodiscard]] bool is_valid_simplex(Vertex v) const { return vertices_.contains(v); }
    [[nodiscard]] bool is_valid_simplex(const EdgeKey& e) const { return edges_.contains(e); }
    [[nodiscard]] bool is_valid_simplex(const TriangleKey& t) const {
        return triangles_.contains(t);
    }

    [[nodiscard]] Phase phase(const TriangleKey& t) const { return phases_.at(t); }
    void set_phase(const TriangleKey& t, Phase phase) { phases_.at(t) = phase; }

    // --- coordinates: a 0-simplex attribute vector ----------------------------------------------
    [[nodiscard]] const Point<double>& coord(Vertex v) const { return coords_[v.id]; }
    void set_coord(Vertex v, const Point<double>& p) { coords_[v.id] = p; }

    // --- the look-up behind star, without a copy ------------------------------------------------
    [[nodiscard]] const std::set<EdgeKey>& edges_at(Vertex v) const { return edges_at_[v.id]; }
    [[nodiscard]] const std::set<TriangleKey>& triangles_at(Vertex v) const {
        return triangles_at_[v.id];
    }
    [[nodiscard]] const std::set<TriangleKey>& triangles_at(const EdgeKey& e) const {
        return edges_.at(e);
    }
    /// The oriented simplex [v0, v1, v2] of a triangle.
    [[nodiscard]] const OrientedTriangle& oriented(const TriangleKey& t) const {
        return triangles_.at(t);
    }

    // --- all simplices --------------------------------------------------------------------------
    [[nodiscard]] const std::set<Vertex>& vertices() const { return vertices_; }
    /// Each edge with the triangles that have it as a face.
    [[nodiscard]] const EdgeAttribute<std::set<TriangleKey>>& edges() const { return edges_; }
    [[nodiscard]] const TriangleAttribute<OrientedTriangle>& triangles() const {
        return triangles_;
    }
    [[nodiscard]] const TriangleAttribute<Phase>& phases() const { return phases_; }
    /// Numbers of vertices are below this bound: the length of a 0-simplex attribute vector.
    [[nodiscard]] std::size_t vertex_bound() const { return coords_.size(); }

    // --- set by the caller ----------------------------------------------------------------------
    std::set<Vertex> locked;            ///< may neither be moved nor removed
    std::set<Vertex> boundary_features; ///< points of the domain boundary that are kept
    // From the submeshing method (thesis, section 8.6).
    std::set<Vertex> submesh_boundary_vertices;
    std::set<EdgeKey> submesh_boundary_edges;
    /// Edges of the submesh boundary that are interface edges in the whole mesh. The thesis does
    /// not need them, because they are locked; but a collapse beside one would fold another
    /// interface edge onto it.
    std::set<EdgeKey> submesh_boundary_interface;
    /// Called after a vertex `m` was inserted between `a` and `b` (thesis, section 8.9); may be
    /// empty.
    std::function<void(Vertex m, Vertex a, Vertex b)> interpolate;

private:
    [[nodiscard]] bool is_interface(const EdgeKey& e, const std::set<TriangleKey>& T) const;

    std::set<Vertex> vertices_;
    EdgeAttribute<std::set<TriangleKey>> edges_;
    TriangleAttribute<OrientedTriangle> triangles_;
    TriangleAttribute<Phase> phases_;
    VertexAttribute<Point<double>> coords_;
    VertexAttribute<std::set<EdgeKey>> edges_at_;
    VertexAttribute<std::set<TriangleKey>> triangles_at_;
    std::vector<Vertex> free_;
};

/// Builds K: vertex i is points[i]; triangles may be oriented either way; one phase per triangle.
/// Throws InputError for an index out of range, a coordinate that is not finite, a triangle without
/// area, an edge with more than two triangles, or a wrong number of phases.
Complex make_complex(std::span<const Point<double>> points,
                     std::span<const std::array<std::uint32_t, 3>> triangles,
                     std::span<const Phase> phases);

/// K as arrays, with vertices renumbered in ascending order and triangles counter-clockwise.
struct Arrays {
    std::vector<Point<double>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Phase> phases;
};
Arrays to_arrays(const Complex& K);

} // namespace dsc::reference
