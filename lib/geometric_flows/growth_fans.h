// SPDX-License-Identifier: MIT
// Fans of a growing front: where two of its sheets move apart, an arc opens between them.
#pragma once

#include "geometric_flows/growth_front.h"

namespace dsc {

/// Puts a fan of vertices beside a feature that opens, each with its ray. O(vertices of the fan).
template <class Real>
void open_fan(GrowthFronts<Real>& fronts, std::uint32_t v, const GrowthBend<Real>& bend);

/// Moves a vertex of a fan to its ray as soon as there is room; dissolves the fan where it has
/// grown or its rays bend, and closes it where it would vanish in this sub-step. O(degree).
template <class Real>
void tend_fan(GrowthFronts<Real>& fronts, const Star<Real>& star, const GrowthBend<Real>& bend);

} // namespace dsc
