// SPDX-License-Identifier: MIT
// Notches of a growing front, where two of its sheets run into each other.
#pragma once

#include "geometric_flows/growth_front.h"

namespace dsc {

/// Makes a vertex a feature where the front turns into itself, and a plain vertex where it is
/// smooth. O(1).
template <class Real>
void mark_notch(GrowthFronts<Real>& fronts, std::uint32_t v, const GrowthBend<Real>& bend);

/// Removes the vertex if the notch at the end of one of its edges will run over it. Also true if
/// only another submesh can decide this. O(degree).
template <class Real>
[[nodiscard]] bool remove_before_notch(GrowthFronts<Real>& fronts, const Star<Real>& star,
                                       const GrowthBend<Real>& bend);

} // namespace dsc
