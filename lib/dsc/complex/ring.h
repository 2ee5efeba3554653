// SPDX-License-Identifier: MIT
// The star of one vertex, gathered once (gather.h): the link's coordinates in small padded arrays,
// so that quality, move limit, lengths and Delaunay tests run on all lanes at once. Only min and
// max are reduced across lanes; the result does not depend on their order.
#pragma once

#include "dsc/complex/corner.h"

#include <array>

namespace dsc {

/// The star of a vertex, with room for a degree of `capacity`.
template <class Real>
struct Ring {
    static constexpr std::uint32_t lanes = 8;     ///< padding; a multiple of every vector width
    static constexpr std::uint32_t capacity = 56; ///< the largest degree that fits
    static constexpr std::uint32_t room = capacity + 2 * lanes; ///< of each array: with the padding

    std::uint32_t vertex = no_id; ///< its id
    std::uint32_t size = 0;       ///< triangles of the star
    bool closed = false;          ///< false: the vertex is on the domain boundary
    bool one_phase = false;       ///< all triangles have the same phase
    bool owned = true;            ///< all vertices of the link, and the centre, lie in the region
    Real x0 = 0;                  ///< the centre
    Real y0 = 0;

    // Triangle i is the centre, (x, y)[i] and (x_next, y_next)[i], counter-clockwise; the padding
    // repeats triangle 0. These are the link vertices i and i + 1; link[size] closes the ring, or
    // is the last vertex of an open one. Spoke 0 of an open ring has no predecessor: its
    // (x_previous, y_previous) is link vertex 0 itself. Neighbours are stored rather than shuffled:
    // a vector load that spans two recent stores has to wait for both.
    alignas(64) std::array<Real, room> x;          ///< link vertex i
    alignas(64) std::array<Real, room> y;          ///< link vertex i
    alignas(64) std::array<Real, room> x_next;     ///< link vertex i + 1
    alignas(64) std::array<Real, room> y_next;     ///< link vertex i + 1
    alignas(64) std::array<Real, room> x_previous; ///< link vertex i - 1
    alignas(64) std::array<Real, room> y_previous; ///< link vertex i - 1
    std::array<std::uint32_t, room> link;          ///< ids of the link's vertices
    std::array<Corner, room> corner;               ///< of the centre in triangle i
    std::array<Phase, room> phase;                 ///< of triangle i

    /// The size rounded up to whole lanes.
    [[nodiscard]] std::uint32_t padded() const { return (size + lanes - 1) / lanes * lanes; }
    /// Vertices of the link.
    [[nodiscard]] std::uint32_t link_size() const { return closed ? size : size + 1; }
    /// The x coordinate of link vertex i; also of the last one of an open star.
    [[nodiscard]] Real link_x(std::uint32_t i) const { return i < size ? x[i] : x_next[size - 1]; }
    /// The y coordinate of link vertex i; also of the last one of an open star.
    [[nodiscard]] Real link_y(std::uint32_t i) const { return i < size ? y[i] : y_next[size - 1]; }
    /// The phase between link vertex i - 1 and i (that is, clockwise of spoke i).
    [[nodiscard]] Phase phase_before(std::uint32_t i) const {
        return i > 0 ? phase[i - 1] : (closed ? phase[size - 1] : border_phase);
    }
    /// The phase between link vertex i and i + 1 (counter-clockwise of spoke i).
    [[nodiscard]] Phase phase_after(std::uint32_t i) const {
        return i < size ? phase[i] : border_phase;
    }
    /// Spoke i separates two phases, or the domain from the outside.
    [[nodiscard]] bool is_constrained(std::uint32_t i) const {
        return phase_before(i) != phase_after(i);
    }
};

} // namespace dsc
