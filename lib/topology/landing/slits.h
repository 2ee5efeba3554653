// SPDX-License-Identifier: MIT
// Fills the slits that keep a vertex from landing on the domain boundary.
#pragma once

#include "topology/region.h"

namespace dsc {

/// Fills the slit whose mouth blocks the vertex: a triangle with two long sides on the interface,
/// whose mouth, at the vertex, is narrower than the contact distance. One event for each triangle.
/// O(degree).
template <class Real>
void fill_slits(TopologyWork<Real>& work, std::uint32_t v);

} // namespace dsc
