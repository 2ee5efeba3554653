// SPDX-License-Identifier: MIT
// Basic types that all other files use: points, phases, handles and corners.
#pragma once

#include <Eigen/Core>

#include <compare>
#include <cstdint>

namespace dsc {

/// A point or a vector of the plane. `Real` is `double` or `float`.
template <class Real>
using Point = Eigen::Matrix<Real, 2, 1>;

/// The number of a phase, that is, of a material (thesis, section 8.6). Phases are small integers;
/// more than two may meet.
using Phase = std::uint32_t;

/// The phase around everything else; a domain edge of any other phase is part of the interface
/// (thesis, figure 8.3).
inline constexpr Phase exterior_phase = 0;

/// The phase of the border triangle, which stands in for "no neighbour". Never given by a user.
inline constexpr Phase border_phase = 0xffffffffU;

/// The id of no simplex; the initial id of every handle.
inline constexpr std::uint32_t no_id = 0xffffffffU;

/// A simplex by number. `Vertex`, `Edge` and `Triangle` are distinct types that do not compare
/// with each other and do not convert to integers by themselves.
template <class Tag>
struct Handle {
    std::uint32_t id = no_id; ///< of the simplex; edges are named by a corner

    /// Whether the handle has an id. Its simplex may still be dead: see `Complex::is_alive`.
    [[nodiscard]] constexpr bool is_valid() const { return id != no_id; }
    friend constexpr auto operator<=>(Handle, Handle) = default;
};

struct VertexTag;
struct EdgeTag;
struct TriangleTag;

/// A 0-simplex.
using Vertex = Handle<VertexTag>;
/// A 1-simplex: the smaller of the (one or two) corners that lie opposite to it.
using Edge = Handle<EdgeTag>;
/// A 2-simplex.
using Triangle = Handle<TriangleTag>;

/// Whether an edge between these two phases, in either order, is an interface edge. The outside of
/// the domain counts as exterior (thesis, section 8.6).
constexpr bool is_interface_pair(Phase one, Phase other) {
    return (one == border_phase ? exterior_phase : one) !=
           (other == border_phase ? exterior_phase : other);
}

/// A corner is 4 * triangle + 0, 1 or 2. It names a vertex of a triangle, the edge opposite to it,
/// and the half-edge of that edge inside the triangle, so no index has to be searched for.
using Corner = std::uint32_t;

/// Triangle 0 is the border: it stands in for a missing neighbour. Its phase differs from all
/// others, so "phases differ" means "constrained" for both the interface and the domain boundary.
inline constexpr std::uint32_t border_triangle = 0;
/// A corner of the border: the twin of all corners at edges of the domain boundary.
inline constexpr Corner border_corner = 0;

/// Ids of triangles are below this: there are four corners for each.
inline constexpr std::uint32_t triangle_limit = no_id / 4;

/// The triangle of a corner.
constexpr std::uint32_t triangle_of(Corner corner) { return corner >> 2U; }
/// The index of a corner in its triangle: 0, 1 or 2.
constexpr std::uint32_t index_of(Corner corner) { return corner & 3U; }
/// Corner `index` (0, 1 or 2) of a triangle.
constexpr Corner corner_of(std::uint32_t triangle, std::uint32_t index) {
    return (triangle << 2U) + index;
}
/// The index after another one, counter-clockwise.
constexpr std::uint32_t next_index(std::uint32_t index) { return index == 2 ? 0 : index + 1; }
/// The index before another one, counter-clockwise.
constexpr std::uint32_t prev_index(std::uint32_t index) { return index == 0 ? 2 : index - 1; }
/// The next corner of the same triangle, counter-clockwise.
constexpr Corner next(Corner corner) { return index_of(corner) == 2 ? corner - 2 : corner + 1; }
/// The previous corner of the same triangle, counter-clockwise.
constexpr Corner prev(Corner corner) { return index_of(corner) == 0 ? corner + 2 : corner - 1; }
/// Whether a corner belongs to the border: there is no neighbour.
constexpr bool is_border(Corner corner) { return corner < 4; }

/// A base class of objects that are neither copied nor moved, because others refer to them.
struct Unmovable {
    Unmovable() = default;
    Unmovable(const Unmovable&) = delete;
    Unmovable& operator=(const Unmovable&) = delete;
};

} // namespace dsc
