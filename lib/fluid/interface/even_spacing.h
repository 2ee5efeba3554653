// SPDX-License-Identifier: MIT
// Spreads the vertices of an interface: the flow crowds them in one place and draws them apart in
// another, splits halve edges, and a polygon of unequal edges is not at rest where an equal one is.
#pragma once

#include "dsc/dsc.h"

namespace dsc {

/// Slides targets along the cubic through their curve (`curve_point`), each by a quarter of the
/// difference between its two edges: what differs from one edge to the next is gone after a call,
/// and differences over n edges after about n^2 of them. Junctions, corners, locked vertices and
/// those on the domain boundary stay. The curve is kept to the fourth order in its edges.
/// O(interface).
void space_evenly(const InterfaceView<double>& view, std::span<Point<double>> targets);

} // namespace dsc
