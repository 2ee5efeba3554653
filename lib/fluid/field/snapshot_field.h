// SPDX-License-Identifier: MIT
// Velocity and pressure with a copy of their mesh: later steps interpolate there, so no values have
// to be transferred through the edits of the mesh.
#pragma once

#include "dsc/base/archive.h"
#include "fluid/field/quadratic.h"

#include <vector>

namespace dsc {

/// A triangle with its six nodes.
struct SnapshotTriangle {
    /// The vertices, counter-clockwise, then the midpoints of the edges opposite to them.
    std::array<std::uint32_t, 6> nodes;
    std::array<std::uint32_t, 3>
        across;  ///< triangles across these edges; no_id: outside the domain
    Phase phase; ///< of the fluid
};

/// An edge between two phases.
struct SnapshotEdge {
    std::uint32_t from;   ///< a vertex
    std::uint32_t to;     ///< the other end
    std::uint32_t middle; ///< the node between them
    Phase left;           ///< of the triangle on the left, looking from `from` to `to`
    Phase right;          ///< of the triangle on the right
};

/// A copy of a complex with a number for each edge. Node i is the vertex of that id, for i below
/// `vertex_bound`; the others are the midpoints of edges.
struct MeshSnapshot {
    Rectangle domain;                        ///< the box around all vertices
    std::uint32_t vertex_bound = 0;          ///< of the complex
    std::vector<Point<double>> nodes;        ///< positions; (0, 0) for free ids
    std::vector<SnapshotTriangle> triangles; ///< the living ones
    std::vector<SnapshotEdge> interface;     ///< each edge between two phases once
    std::vector<std::uint32_t> triangle_at;  ///< by vertex id: a triangle of the vertex, or no_id
    std::vector<std::uint32_t> features;     ///< marked vertices of the domain boundary, by id
};

/// A copy of the complex. O(n).
[[nodiscard]] MeshSnapshot snapshot_of(const Complex<double>& complex);

/// The area of a triangle. O(1).
[[nodiscard]] double area(const MeshSnapshot& mesh, const SnapshotTriangle& triangle);

/// The gradients of the barycentric coordinates of a triangle with this area, as columns. O(1).
[[nodiscard]] Eigen::Matrix<double, 2, 3> slopes_of(const MeshSnapshot& mesh,
                                                    const SnapshotTriangle& triangle, double area);

/// The start of a search: the triangle of the vertex with this id in the mesh, if there was one,
/// else the first triangle. The triangle found, and with it the last bits, depends on the point and
/// this start only.
[[nodiscard]] std::uint32_t start_at(const MeshSnapshot& mesh, std::uint32_t vertex);

/// A point of a mesh.
struct Spot {
    std::uint32_t triangle = 0; ///< the triangle that contains the point, up to rounding
    Barycentric at{};           ///< its coordinates there
};

/// The spot of a point, which is first moved into the domain. The search begins at the triangle
/// `start`. O(triangles on the way).
[[nodiscard]] Spot find_spot(const MeshSnapshot& mesh, Point<double> point, std::uint32_t start);

/// A solution at one time. Reading is thread-safe.
struct FluidField {
    MeshSnapshot mesh; ///< in which it was found
    double time = 0;   ///< of the solution
    /// By node; linear along each interface edge, quadratic elsewhere.
    std::vector<Point<double>> velocity = {};
    /// By triangle, at its vertices: linear, continuous in each phase, with a jump where phases
    /// meet. Its mean over the domain is 0; with a void, the pressure in the void is 0. Force per
    /// length.
    std::vector<std::array<double, 3>> pressure = {};
    /// By side of the options: the force of the fluid on it. Without slip it has the order of the
    /// energy norm squared, because it is the rest of the equations of the nodes there (weak form).
    std::vector<Point<double>> side_forces = {};
};

/// Throws FileError if an index is out of range. O(n).
void archive(Archive& archive, FluidField& field);

/// The velocity at a spot of the field's mesh. O(1).
[[nodiscard]] Point<double> velocity_at(const FluidField& field, const Spot& spot);
/// The derivative of the velocity at a spot along a way, times the way's length. O(1).
[[nodiscard]] Point<double> velocity_along(const FluidField& field, const Spot& spot,
                                           const Point<double>& way);
/// The pressure at a spot, of the phase of its triangle. O(1).
[[nodiscard]] double pressure_at(const FluidField& field, const Spot& spot);

} // namespace dsc
