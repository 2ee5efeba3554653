// SPDX-License-Identifier: MIT
// Scalars, points and handles, which all other files use.
#pragma once

#include <Eigen/Core>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

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

} // namespace dsc

template <class Tag>
struct std::hash<dsc::Handle<Tag>> {
    std::size_t operator()(dsc::Handle<Tag> handle) const noexcept { return handle.id; }
};
