// SPDX-License-Identifier: MIT
// Where a film may open: two triangles side by side, one at each of its sheets.
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

/// The contact distance at a half-edge on the interface; 0 if it has to stay. Where it is more than
/// single triangles span, which is the matter of wide_films.h, the default.
template <class Real>
[[nodiscard]] Real contact_at(const TopologyWork<Real>& work, Corner sheet);

/// The two half-edges face each other, with a film of the phase on their left between them. O(1).
template <class Real>
[[nodiscard]] bool faces(const Complex<Real>& complex, Corner one, Corner other);

/// Both half-edges lie on a seam. Where a bridge has opened, the two ends of its seam face each
/// other as well, and what is between them is as thin as the film was. That is not a film, unless
/// they hold up each other. O(1).
template <class Real>
[[nodiscard]] bool are_ends_of_seam(const TopologyWork<Real>& work, Corner one, Corner other);

/// The flow takes area from the film between the two half-edges, or they hold up each other.
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

/// Thin enough for one of the phases across its edges, and not at the domain boundary.
template <class Real>
[[nodiscard]] bool is_thin(const TopologyWork<Real>& work, Triangle t);

/// The half-edges of a triangle that lie on the interface; returns their number.
template <class Real>
int sheets_of(const Complex<Real>& complex, Triangle t, std::array<Corner, 3>& sheets);

/// The thinner of the bridges of a thin triangle, if the film is to open there. `candidates`: of
/// the change; `VertexRecord::slot` of each is its index there. O(degrees).
template <class Real>
[[nodiscard]] bool find_bridge(const TopologyWork<Real>& work,
                               std::span<const Candidate> candidates, Triangle t,
                               Bridge<Real>& best);

} // namespace dsc
