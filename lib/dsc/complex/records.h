// SPDX-License-Identifier: MIT
// A vertex and a triangle in memory: contiguous records of 32 bytes (vertices of float: 24).
#pragma once

#include "dsc/base/types.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace dsc {

/// Bits of `VertexRecord::flags`.
enum VertexFlag : std::uint32_t {
    vertex_dead = 1U,   ///< the id is free
    vertex_locked = 2U, ///< the application forbids the vertex to move or vanish
    /// This bit and the next count the steps in which the vertex did not arrive, up to three. A
    /// vertex with both bits set is in contact: until it arrives, each step tries it only once.
    vertex_missed = 4U,
    vertex_contact = 12U,
    vertex_feature = 16U,          ///< a feature: it is kept, and the curve has no tangent there
    vertex_on_way = 32U,           ///< the vertex was moved or deferred, and has not arrived yet
    vertex_boundary_feature = 64U, ///< a feature of the domain boundary: it is kept where it is
};

/// A triangle, by id.
struct TriangleRecord {
    std::array<std::uint32_t, 3> v; ///< vertices, counter-clockwise; v[0] == no_id: the id is free
    std::array<Corner, 3> n;        ///< the corner on the other side of the edge opposite to v[i]
    Phase phase;                    ///< of the material
    std::uint32_t mark;             ///< scratch of algorithms; holds no state between calls
};
static_assert(sizeof(TriangleRecord) == 32);

/// A vertex, by id.
template <class Real>
struct VertexRecord {
    Real x;              ///< position, in units of the domain
    Real y;              ///< position, in units of the domain
    Corner corner;       ///< any corner at this vertex; no_id while it has no triangle
    std::uint32_t flags; ///< VertexFlag
    std::uint32_t stamp; ///< scratch of the active set
    std::uint32_t slot;  ///< scratch of the active set
};
static_assert(sizeof(VertexRecord<double>) == 32);

// Coordinates of a vertex that another submesh may be moving at this moment: such a vertex always
// fails the test of ownership, so the order of reads and writes does not matter, but none may tear.

/// Reads without tearing: returns a value that the variable had at some moment.
template <class Real>
Real read_shared(const Real& value) {
    return std::atomic_ref<Real>(const_cast<Real&>(value)).load(std::memory_order_relaxed);
}
/// Writes without tearing.
template <class Real>
void write_shared(Real& value, Real next) {
    std::atomic_ref<Real>(value).store(next, std::memory_order_relaxed);
}

} // namespace dsc
