// SPDX-License-Identifier: MIT
// Spaces the vertices of an interface evenly. The flow and splits make edges unequal, and under
// tension a polygon of unequal edges is not at rest, unlike one of equal edges.
#pragma once

#include "dsc/dsc.h"

namespace dsc {

/// Slides targets along the cubic through their curve (`curve_point`), each by a quarter of the
/// difference between its two edges. Differences between neighbouring edges vanish after one call,
/// and differences over n edges after about n^2 calls. Junctions, features, locked vertices and
/// those on the domain boundary stay. The curve changes to fourth order in its edges only.
/// O(interface).
void space_evenly(const InterfaceView<double>& view, std::span<Point<double>> targets);

} // namespace dsc
