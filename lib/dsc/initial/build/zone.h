// SPDX-License-Identifier: MIT
// The part of a new complex that may be improved: what lies near the interface.
#pragma once

#include "dsc/complex/complex.h"

#include <span>
#include <vector>

namespace dsc::initial {

/// Whether the star of a vertex has changed since it was last looked at; kept in the vertices'
/// `slot` while the complex is built. A star that could not be improved is not tried again.
inline constexpr std::uint32_t unsettled = no_id;
inline constexpr std::uint32_t settled = 0;

/// The unsettled vertices within a few edges of the interface, and beyond these wherever short
/// edges have not yet grown to the target; the interface first. O(vertices near the interface).
template <class Real>
std::vector<std::uint32_t> find_zone(Complex<Real>& complex,
                                     std::span<const std::uint32_t> interface_vertices,
                                     double edge_length);

} // namespace dsc::initial
