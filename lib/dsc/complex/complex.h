// SPDX-License-Identifier: MIT
// The data structure: a triangulated domain whose triangles carry phases. The interface, the domain
// boundary and the submesh boundary are derived from it, never stored twice (thesis, section 8.6).
// The complex owns connectivity, phases, positions and attributes; algorithms are free functions.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/attributes.h"
#include "dsc/complex/edit_log.h"
#include "dsc/complex/ids.h"
#include "dsc/complex/records.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace dsc {

/// Whether a simulation uses a complex. Not part of the complex's value: a copy is free, and
/// assignment changes nothing.
class InUse {
public:
    InUse() = default;
    /// Free.
    InUse(const InUse& /*other*/) {}
    /// Free.
    InUse(InUse&& /*other*/) noexcept {}
    /// Changes nothing.
    InUse& operator=(const InUse& /*other*/) { return *this; }
    /// Changes nothing.
    InUse& operator=(InUse&& /*other*/) noexcept { return *this; }
    ~InUse() = default;

    /// Throws InputError if a simulation uses the complex.
    void expect_free() const;

    bool by_a_simulation = false; ///< written by `Simulation`
};

/// A two-dimensional simplicial complex that is a manifold with boundary (thesis, section 3.2).
/// Reading is thread-safe; writing is safe from several threads only through submeshes that own
/// disjoint regions (see submesh.h).
template <class Real>
class Complex {
public:
    using Scalar = Real; ///< the type of coordinates

    /// Without vertices and triangles.
    Complex();
    /// An independent copy, with attributes and free ids, but without recorded edits and without a
    /// simulation.
    Complex(const Complex&) = default;
    /// Moves the other complex, which is empty afterwards and may be used again. Terminates the
    /// program if there is no memory for an empty complex.
    Complex(Complex&& other) noexcept;
    /// Replaces the mesh by a copy; if that throws, nothing has changed. Handles and references to
    /// attributes become invalid; a simulation of this complex continues with the new mesh.
    Complex& operator=(const Complex& other);
    /// The same without copying; the other one is empty afterwards.
    Complex& operator=(Complex&& other) noexcept;
    ~Complex() = default;

    // --- counts -------------------------------------------------------------------------------
    [[nodiscard]] std::uint32_t vertex_count() const;   ///< living vertices; O(submeshes)
    [[nodiscard]] std::uint32_t triangle_count() const; ///< living triangles; O(submeshes)
    /// Ids are below these bounds; some may be free. Triangle 0 is the border and never counted.
    [[nodiscard]] std::uint32_t vertex_bound() const {
        return static_cast<std::uint32_t>(vertices.size());
    }
    /// The same for triangles.
    [[nodiscard]] std::uint32_t triangle_bound() const {
        return static_cast<std::uint32_t>(triangles.size());
    }

    // --- living simplices ---------------------------------------------------------------------
    /// Whether the handle names a living vertex. O(1).
    [[nodiscard]] bool is_alive(Vertex v) const {
        return v.id < vertices.size() && (vertices[v.id].flags & vertex_dead) == 0;
    }
    /// Whether the handle names a living triangle. O(1).
    [[nodiscard]] bool is_alive(Triangle t) const {
        return t.id != border_triangle && t.id < triangles.size() && triangles[t.id].v[0] != no_id;
    }
    /// True for the canonical handle of a living edge.
    [[nodiscard]] bool is_alive(Edge e) const {
        return (e.id >> 2U) < triangles.size() && index_of(e.id) < 3 &&
               is_alive(Triangle{triangle_of(e.id)}) && edge(e.id) == e;
    }

    // --- navigation ---------------------------------------------------------------------------
    /// The id of the vertex at a corner.
    [[nodiscard]] std::uint32_t vertex(Corner c) const {
        return triangles[triangle_of(c)].v[index_of(c)];
    }
    /// The corner on the other side of the edge opposite to `c`; below 4 at the domain boundary.
    [[nodiscard]] Corner twin(Corner c) const { return triangles[triangle_of(c)].n[index_of(c)]; }
    /// The phase of the triangle of a corner; `border_phase` for the border's.
    [[nodiscard]] Phase phase_at(Corner c) const { return triangles[triangle_of(c)].phase; }
    /// The edge opposite to `c`.
    [[nodiscard]] Edge edge(Corner c) const {
        const Corner other = twin(c);
        return Edge{!is_border(other) && other < c ? other : c};
    }
    /// The two ends of an edge: the half-edge opposite to the edge's corner runs from the first to
    /// the second.
    [[nodiscard]] std::array<Vertex, 2> vertices_of(Edge e) const {
        return {Vertex{vertex(next(e.id))}, Vertex{vertex(prev(e.id))}};
    }
    /// The three vertices of a triangle, counter-clockwise.
    [[nodiscard]] std::array<Vertex, 3> vertices_of(Triangle t) const {
        const auto& v = triangles[t.id].v;
        return {Vertex{v[0]}, Vertex{v[1]}, Vertex{v[2]}};
    }
    /// The three edges of a triangle, each opposite to the vertex of the same number.
    [[nodiscard]] std::array<Edge, 3> edges_of(Triangle t) const {
        return {edge(corner_of(t.id, 0)), edge(corner_of(t.id, 1)), edge(corner_of(t.id, 2))};
    }
    /// The corner opposite to the half-edge from `a` to `b`, or no_id. O(degree of a).
    [[nodiscard]] Corner find_half_edge(Vertex a, Vertex b) const;
    /// The edge between two vertices, or an invalid handle. O(degree of a).
    [[nodiscard]] Edge find_edge(Vertex a, Vertex b) const;

    // --- geometry and phases ------------------------------------------------------------------
    /// The position of a vertex, in units of the domain.
    [[nodiscard]] Point<Real> position(Vertex v) const {
        return {vertices[v.id].x, vertices[v.id].y};
    }
    /// The positions of the three vertices of a triangle, counter-clockwise.
    [[nodiscard]] std::array<Point<Real>, 3> positions_of(Triangle t) const {
        const auto& v = triangles[t.id].v;
        return {position(Vertex{v[0]}), position(Vertex{v[1]}), position(Vertex{v[2]})};
    }
    /// Moves a vertex, even if a triangle is inverted. Noted in `journal`.
    void set_position(Vertex v, const Point<Real>& p);
    /// The phase of a living triangle.
    [[nodiscard]] Phase phase(Triangle t) const { return triangles[t.id].phase; }
    /// Changes the phase of a living triangle. Noted in `journal`.
    void set_phase(Triangle t, Phase phase);
    /// Whether the application forbids the vertex to move or vanish.
    [[nodiscard]] bool is_locked(Vertex v) const {
        return (vertices[v.id].flags & vertex_locked) != 0;
    }
    /// Forbids a vertex to move or vanish, or allows it. Operations answer `Verdict::locked`.
    void set_locked(Vertex v, bool locked) { set_flag(v, vertex_locked, locked); }
    /// Whether the vertex is a feature of the interface: it is kept, and the curve has no tangent
    /// there.
    [[nodiscard]] bool is_feature(Vertex v) const {
        return (vertices[v.id].flags & vertex_feature) != 0;
    }
    /// Makes a vertex of the interface a feature, or an ordinary point of its curve. The next step
    /// takes account of it; O(1).
    void set_feature(Vertex v, bool feature) { set_flag(v, vertex_feature, feature); }
    /// Whether the vertex is marked as a feature of the domain boundary, which is kept where it is,
    /// such as the end of a side. `make_complex` marks turns above `side_turn_degrees`; turns above
    /// `side_corner_degrees`, such as the corners of a rectangle, are kept also without a mark.
    [[nodiscard]] bool is_boundary_feature(Vertex v) const {
        return (vertices[v.id].flags & vertex_boundary_feature) != 0;
    }
    /// Makes a vertex of the domain boundary a feature, or an ordinary point of its side. The next
    /// step takes account of it; O(1).
    void set_boundary_feature(Vertex v, bool feature) {
        set_flag(v, vertex_boundary_feature, feature);
    }

    // --- ids ----------------------------------------------------------------------------------
    /// Makes sure that the pool has this many free ids, so that taking them cannot fail. Returns
    /// false, and does nothing, if the pool would have to grow and may not. Throws InputError if
    /// there are no more ids; an exception leaves the complex as it was.
    [[nodiscard]] bool have_ids(IdPool& pool, std::size_t vertex_total,
                                std::size_t triangle_total) {
        return (pool.vertices.size() >= vertex_total && pool.triangles.size() >= triangle_total) ||
               (pool.may_grow && (grow(pool, vertex_total, triangle_total), true));
    }
    /// Takes an id from the pool, which grows if it is empty; no_id if it may not grow.
    std::uint32_t take_vertex(IdPool& pool);
    /// The same for a triangle.
    std::uint32_t take_triangle(IdPool& pool);
    /// Puts an id back; the vertex is dead from then on.
    void give_vertex(IdPool& pool, std::uint32_t id);
    /// Puts an id back; the triangle is dead from then on.
    void give_triangle(IdPool& pool, std::uint32_t id);
    /// Reserves room for that many vertices and triangles and for their existing attributes: up to
    /// that number, new ids copy nothing. O(n) if there is less room.
    void reserve(std::size_t vertex_total, std::size_t triangle_total);

    // --- attributes ---------------------------------------------------------------------------
    AttributeSet attributes; ///< data of the application; follows every operation

    /// The log of edits of the whole complex rather than of a submesh, such as those of the
    /// application; a running simulation reads it before its next step.
    EditLog journal;

    InUse in_use; ///< refuses a second simulation at the same time

    // --- the records themselves: for algorithms of the library --------------------------------
    std::vector<VertexRecord<Real>> vertices; ///< by id
    std::vector<TriangleRecord> triangles;    ///< by id; 0 is the border
    FreeIds ids;                              ///< those that no simplex has

private:
    void set_flag(Vertex v, std::uint32_t flag, bool is_set) {
        vertices[v.id].flags = (vertices[v.id].flags & ~flag) | (is_set ? flag : 0U);
    }
    void grow(IdPool& pool, std::size_t vertex_total, std::size_t triangle_total);
};

extern template class Complex<double>;
extern template class Complex<float>;

/// Builds a complex from arrays: `triangles` index into `points` and may be oriented either way;
/// `phases` has one entry per triangle. Throws InputError if a coordinate is not finite, an index
/// is out of range, a triangle is degenerate, an edge has more than two triangles, a vertex is not
/// manifold, a phase is reserved, or triangles overlap. O(n log n). Vertex i of the complex is
/// point i, triangle t the id t + 1.
template <class Real>
Complex<Real> make_complex(std::span<const Point<Real>> points,
                           std::span<const std::array<std::uint32_t, 3>> triangles,
                           std::span<const Phase> phases);

// --- as bytes ------------------------------------------------------------------------------------

/// Writes a complex exactly as it is, or reads it back into one that has the same attributes: ids,
/// free ids in their order, flags, the entries of the attributes, and unread edits. Throws
/// FileError if the bytes hold the other scalar type, other attributes or an invalid complex, and
/// then leaves the complex unchanged. References to attributes stay valid. O(n log n).
template <class Real>
void archive(Archive& archive, Complex<Real>& complex);

void archive(Archive& archive, Edit& edit);
void archive(Archive& archive, OperationCounts& counts);
void archive(Archive& archive, FreeIds& ids);

/// Throws FileError for a list with an id that no vertex of the complex has, dead or alive.
/// O(list).
template <class Real>
void expect_vertices(const Archive& archive, const Complex<Real>& complex,
                     std::span<const std::uint32_t> list);

} // namespace dsc
