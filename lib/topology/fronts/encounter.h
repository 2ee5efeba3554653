// SPDX-License-Identifier: MIT
// Where and when a vertex of a front meets another front on its way along its normal.
#pragma once

#include "topology/fronts/sight.h"

#include <optional>

namespace dsc {

/// The contact distance of the fronts of a sight, within triangles; 0 if they must not meet.
/// O(pairs).
template <class Real>
[[nodiscard]] Real contact_of(const TopologyWork<Real>& work, const Sight<Real>& sight);

/// Where v, which is at a place now, meets the tangent of the other front. Empty if the fronts
/// hardly approach each other. O(1).
template <class Real>
[[nodiscard]] std::optional<Encounter<Real>> encounter_of(const Sight<Real>& sight,
                                                          const Point<Real>& v);

/// The end of a seam beside a vertex of one front, in sector k, if the other front reaches the
/// vertex at the end, or on the seam that the end has left behind: the vertex is a part of the seam
/// then, and would hold up the end. Only reads. O(degrees).
template <class Real>
[[nodiscard]] std::optional<Sight<Real>> see_passed_end(const TopologyWork<Real>& work,
                                                        const Sectors<Real>& sectors,
                                                        std::uint32_t v, std::size_t k);

} // namespace dsc
