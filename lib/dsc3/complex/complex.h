// SPDX-License-Identifier: MIT
// The data structure: tets and vertices in contiguous arrays. A neighbour is stored as 4 * tet +
// opposite corner, so no index has to be searched for. Faces and edges are derived, and so is the
// interface: the faces between tets of different phases.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/complex/complex.h"
#include "dsc3/base/types.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace dsc {

template <>
struct HandleKind<dsc3::Vertex> {
    static constexpr SimplexKind value = SimplexKind::vertex;
};
template <>
struct HandleKind<dsc3::Tet> {
    static constexpr SimplexKind value = SimplexKind::triangle;
};

} // namespace dsc

namespace dsc3 {

/// One value for each vertex; see `Complex::attributes`.
template <class T>
using VertexAttribute = dsc::Attribute<T, Vertex>;
/// One value for each tet.
template <class T>
using TetAttribute = dsc::Attribute<T, Tet>;

/// Properties of a vertex. All but `vertex_dead` and `vertex_settled` follow from the tets around
/// it; `validate` checks them.
enum VertexFlag : std::uint32_t {
    vertex_interface = 1U, ///< on a face between two phases
    vertex_dead = 4U,      ///< the id is free
    /// Smoothing cannot improve the star until it changes.
    vertex_settled = 8U,
    /// On a side of the domain that is perpendicular to the axis: the coordinate is fixed, so the
    /// vertex stays on the side. On a side that is oblique, all three are.
    vertex_fixed_x = 16U,
    vertex_fixed_y = 32U, ///< the same for y
    vertex_fixed_z = 64U, ///< the same for z
    /// On the domain boundary: any of the three.
    vertex_boundary = vertex_fixed_x | vertex_fixed_y | vertex_fixed_z,
};

/// A tet, by id.
struct TetRecord {
    std::array<std::uint32_t, 4> v; ///< positively oriented; v[0] == no_id: the id is free
    std::array<Corner, 4> n;        ///< the corner on the other side of the face opposite to v[i]
};
static_assert(sizeof(TetRecord) == 32);

/// A vertex, by id.
struct VertexRecord {
    Point position = Point::Zero();    ///< in units of the domain
    Corner corner = no_id;             ///< any corner at this vertex
    std::uint32_t flags = vertex_dead; ///< VertexFlag
};
static_assert(sizeof(VertexRecord) == 32);

/// A three-dimensional simplicial complex that is a manifold with boundary. Reading is thread-safe.
class Complex {
public:
    Complex();

    // --- counts -------------------------------------------------------------------------------
    /// Living vertices; O(1).
    [[nodiscard]] std::uint32_t vertex_count() const {
        return vertex_bound() - static_cast<std::uint32_t>(free_vertices.size());
    }
    /// Living tets; O(1).
    [[nodiscard]] std::uint32_t tet_count() const {
        return tet_bound() - 1 - static_cast<std::uint32_t>(free_tets.size());
    }
    /// Ids are below these bounds; some may be free. Tet 0 is the border and never counted.
    [[nodiscard]] std::uint32_t vertex_bound() const {
        return static_cast<std::uint32_t>(vertices.size());
    }
    /// The same for tets.
    [[nodiscard]] std::uint32_t tet_bound() const {
        return static_cast<std::uint32_t>(tets.size());
    }

    // --- what is alive ------------------------------------------------------------------------
    [[nodiscard]] bool is_alive(Vertex v) const {
        return v.id < vertices.size() && (vertices[v.id].flags & vertex_dead) == 0;
    }
    [[nodiscard]] bool is_alive(Tet t) const {
        return t.id != border_tet && t.id < tets.size() && tets[t.id].v[0] != no_id;
    }

    // --- navigation ---------------------------------------------------------------------------
    /// The id of the vertex at a corner.
    [[nodiscard]] std::uint32_t vertex(Corner c) const { return tets[tet_of(c)].v[index_of(c)]; }
    /// The corner on the other side of the face opposite to `c`; below 4 at the domain boundary.
    [[nodiscard]] Corner twin(Corner c) const { return tets[tet_of(c)].n[index_of(c)]; }
    /// The phase of the tet of a corner; `border_phase` for the border's.
    [[nodiscard]] Phase phase_at(Corner c) const { return phases[tet_of(c)]; }
    /// The four vertices of a tet, positively oriented.
    [[nodiscard]] std::array<Vertex, 4> vertices_of(Tet t) const {
        const auto& v = tets[t.id].v;
        return {Vertex{v[0]}, Vertex{v[1]}, Vertex{v[2]}, Vertex{v[3]}};
    }
    /// The vertices of the face opposite to a corner, clockwise as seen from there.
    [[nodiscard]] std::array<std::uint32_t, 3> face(Corner c) const {
        const auto& v = tets[tet_of(c)].v;
        const auto& i = face_indices[index_of(c)];
        return {v[i[0]], v[i[1]], v[i[2]]};
    }

    // --- geometry and phases ------------------------------------------------------------------
    [[nodiscard]] const Point& position(Vertex v) const { return vertices[v.id].position; }
    [[nodiscard]] const Point& at(std::uint32_t vertex) const { return vertices[vertex].position; }
    [[nodiscard]] std::array<Point, 4> positions_of(Tet t) const {
        const auto& v = tets[t.id].v;
        return {at(v[0]), at(v[1]), at(v[2]), at(v[3])};
    }
    /// Moves a vertex, even if a tet is inverted.
    void set_position(Vertex v, const Point& p) {
        vertices[v.id].position = p;
        ++version;
    }
    [[nodiscard]] Phase phase(Tet t) const { return phases[t.id]; }
    /// Changes the phase of a living tet, and updates the interface flags of its vertices. O(star).
    void set_phase(Tet t, Phase phase);
    /// Whether the vertex is on a face between two phases.
    [[nodiscard]] bool is_interface(Vertex v) const {
        return (vertices[v.id].flags & vertex_interface) != 0;
    }
    /// Whether the vertex is on the domain boundary.
    [[nodiscard]] bool is_boundary(Vertex v) const {
        return (vertices[v.id].flags & vertex_boundary) != 0;
    }

    /// The flags `vertex_fixed_x`, `vertex_fixed_y` and `vertex_fixed_z` that two vertices on the
    /// domain boundary have in common, on the same sides; with one vertex twice, its own.
    [[nodiscard]] std::uint32_t fixed_along(std::uint32_t a, std::uint32_t b) const;

    // --- ids ----------------------------------------------------------------------------------
    /// The id of a new vertex, which has no tet yet.
    std::uint32_t take_vertex(const Point& position, std::uint32_t flags);
    /// An id for a tet. Throws InputError if there are no more.
    std::uint32_t take_tet();
    /// Makes at least so many ids free. Throws InputError if there are no more.
    void reserve_ids(std::size_t free_vertex_ids, std::size_t free_tet_ids);
    void give_vertex(std::uint32_t id);
    void give_tet(std::uint32_t id);

    /// Data of the application, added by `attributes.add<dsc3::Vertex>("heat", 20.0)` or for `Tet`.
    /// A vertex that splits an edge gets a blend of the values of both ends; otherwise a vertex
    /// keeps its value: values do not sample a field. A new tet inherits from the nearest of the
    /// replaced tets of its phase. An exception that an attribute throws in an edit is rethrown at
    /// the end of the sub-step.
    dsc::AttributeSet attributes;
    /// Grows with each edit, so that a simulation notices edits of the application.
    std::uint64_t version = 0;
    dsc::InUse in_use; ///< refuses a second simulation at the same time

    // --- the records themselves: for algorithms of the library --------------------------------
    std::vector<VertexRecord> vertices;       ///< by id
    std::vector<TetRecord> tets;              ///< by id; 0 is the border
    std::vector<Phase> phases;                ///< by id of the tet
    std::vector<std::uint32_t> free_vertices; ///< ids without a vertex
    std::vector<std::uint32_t> free_tets;     ///< ids without a tet
};

/// The coordinates that a face of the domain boundary, opposite to a corner, fixes: those that its
/// three vertices have in common; all three, if it is oblique. O(1).
[[nodiscard]] std::uint32_t fixed_at(const Complex& complex, Corner corner);

/// Replaces the fixed coordinates of a place by those of a point: the place is then on the same
/// sides of the domain. O(1).
inline void keep_on_sides(Point& place, const Point& point, std::uint32_t fixed) {
    for (int k = 0; k < 3; ++k) {
        if ((fixed & (vertex_fixed_x << k)) != 0) {
            place[k] = point[k];
        }
    }
}

/// Builds a complex from arrays: `tets` index into `points` and may be oriented either way;
/// `phases` has one entry a tet. Throws InputError if a coordinate is not finite, an index is out
/// of range, a tet is degenerate, a face has more than two tets, or a phase is reserved. `validate`
/// checks whether the result is an embedding. O(n log n). Vertex i of the complex is point i; tet t
/// gets the id t + 1.
[[nodiscard]] Complex make_complex(std::span<const Point> points,
                                   std::span<const std::array<std::uint32_t, 4>> tets,
                                   std::span<const Phase> phases);

/// Writes a complex exactly as it is, or reads it back into one that has the same attributes: ids,
/// free ids in their order, flags, and the entries of the attributes. Throws FileError if the bytes
/// hold other attributes or no valid complex; the complex is then unchanged. References to
/// attributes stay valid. O(n log n).
void archive(dsc::Archive& archive, Complex& complex);

/// Renumbers vertices and tets along a Morton curve, which makes a step a quarter faster, and drops
/// the free ids. All handles become invalid. O(n log n).
void renumber(Complex& complex);
/// Renumbers the tets alone, in place: handles of vertices stay valid. Returns the new id of each
/// old one, `no_id` for free ids. O(n log n).
std::vector<std::uint32_t> renumber_tets(Complex& complex);

/// A hash of the mesh: of the bits of the coordinates of the vertices of all living tets, and of
/// their phases. Independent of ids and of the order of the corners of a tet. O(n).
[[nodiscard]] std::uint64_t mesh_hash(const Complex& complex);

} // namespace dsc3
