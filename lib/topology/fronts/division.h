// SPDX-License-Identifier: MIT
// A part of a film is divided among the fronts about it: each place goes to the front that reaches
// it first.
#pragma once

#include "topology/region.h"

#include <span>
#include <vector>

namespace dsc {

/// A triangle of a film and the phase that it goes to.
struct Share {
    Triangle triangle;
    Phase to;
};

/// Splits the edges of a connected part of a film where the fronts of two of the phases `takers`
/// arrive at the same time (arrival.h), and returns its triangles, each with the phase of the front
/// that reaches it first. The fronts are the sheets of the triangles themselves. Triangles keep
/// their phases. O(edges * sheets).
template <class Real>
[[nodiscard]] std::vector<Share> divide_by_arrival(TopologyWork<Real>& work,
                                                   std::span<const Triangle> part,
                                                   std::span<const Phase> takers);

} // namespace dsc
