// SPDX-License-Identifier: MIT
// Bridges, at which a film may open: two neighbouring triangles, one at each of its sheets.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Two triangles that bridge a film.
template <class Real>
struct Bridge {
    std::array<Corner, 2> sheets; ///< the half-edges on the interface, with the film on their left
    Real thickness;
};

/// The contact distance at a half-edge on the interface; 0 if the half-edge must stay. The default,
/// if the distance is wider than single triangles span: wide_films.h then handles it.
template <class Real>
[[nodiscard]] Real contact_at(const TopologyWork<Real>& work, Corner sheet);

/// Whether the two half-edges face each other across a film of the phase on their left. O(1).
template <class Real>
[[nodiscard]] bool faces(const Complex<Real>& complex, Corner one, Corner other);

/// Whether both half-edges lie on a seam. Where a bridge has opened, the two ends of its seam also
/// face each other, at a distance as small as the film's thickness. The phase between them is not a
/// film, unless the ends block each other. O(1).
template <class Real>
[[nodiscard]] bool are_ends_of_seam(const TopologyWork<Real>& work, Corner one, Corner other);

/// Whether the flow takes area from the film between the two half-edges, or they block each other.
/// `candidates` as in `find_bridge`. O(1).
template <class Real>
[[nodiscard]] bool is_squeezed(const TopologyWork<Real>& work,
                               std::span<const Candidate> candidates,
                               const std::array<Corner, 2>& sheets);

/// The same for two sheets that go from the first point to the second, and from the third to the
/// fourth; `then`: before the sub-step. O(1).
template <class Real>
[[nodiscard]] bool is_squeezed(const std::array<Point<Real>, 4>& then,
                               const std::array<Point<Real>, 4>& now);

/// Whether the triangle is thinner than the contact distance with one of the phases across its
/// edges, and is not at the domain boundary.
template <class Real>
[[nodiscard]] bool is_thin(const TopologyWork<Real>& work, Triangle t);

/// Finds the half-edges of a triangle that lie on the interface; returns their number.
template <class Real>
int sheets_of(const Complex<Real>& complex, Triangle t, std::array<Corner, 3>& sheets);

/// Finds the thinner of the bridges of a thin triangle, if the film is to open there. `candidates`
/// are those of the change of topology; `VertexRecord::slot` of a vertex is its index in the list.
/// O(degrees).
template <class Real>
[[nodiscard]] bool find_bridge(const TopologyWork<Real>& work,
                               std::span<const Candidate> candidates, Triangle t,
                               Bridge<Real>& best);

} // namespace dsc
