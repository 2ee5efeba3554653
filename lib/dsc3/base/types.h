// SPDX-License-Identifier: MIT
// Basic types. Those that do not depend on the dimension come from lib/dsc: phases, handles,
// verdicts, errors, archives.
#pragma once

#include "dsc/base/error.h"
#include "dsc/base/types.h"
#include "dsc/base/verdict.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>

namespace dsc3 {

/// Coordinates are doubles. Floats would be too inaccurate, because volumes are products of three
/// lengths, and hardly faster, because a step is limited by memory access rather than by
/// arithmetic.
using Real = double;

/// A point or a vector of space.
using Point = Eigen::Matrix<Real, 3, 1>;

using dsc::border_phase;
using dsc::Corner;
using dsc::corner_of;
using dsc::exterior_phase;
using dsc::FileError;
using dsc::Handle;
using dsc::index_of;
using dsc::InputError;
using dsc::InvariantError;
using dsc::is_border;
using dsc::no_id;
using dsc::Phase;
using dsc::Unmovable;
using dsc::Verdict;

struct VertexTag;
struct TetTag;
/// A 0-simplex.
using Vertex = Handle<VertexTag>;
/// A 3-simplex.
using Tet = Handle<TetTag>;

/// A corner is 4 * tet + 0, 1, 2 or 3. It names a vertex of a tet, and the face opposite to it. Tet
/// 0 is the border: it takes the place of a missing neighbour, and its phase differs from all
/// others.
inline constexpr std::uint32_t border_tet = 0;
/// A corner of the border: the neighbour across a face of the domain boundary.
inline constexpr Corner border_corner = 0;

/// The tet of a corner.
constexpr std::uint32_t tet_of(Corner corner) { return corner >> 2U; }

/// The three other indices of a tet, such that (i, face_indices[i]...) is an even permutation: the
/// face opposite to corner i, clockwise as seen from that corner.
inline constexpr std::array<std::array<std::uint32_t, 3>, 4> face_indices{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The coordinates in brackets.
[[nodiscard]] inline std::string to_text(const Point& point) {
    return '(' + dsc::to_text(point.x()) + ", " + dsc::to_text(point.y()) + ", " +
           dsc::to_text(point.z()) + ')';
}

} // namespace dsc3
