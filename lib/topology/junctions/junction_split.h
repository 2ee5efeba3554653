// SPDX-License-Identifier: MIT
// A vertex with more sectors than are stable comes apart in the way that lowers the energy of the
// interface the most: a junction moves from it into one of its sectors, or the end of a curve moves
// from it along the domain boundary.
#pragma once

#include "topology/junctions/sectors.h"

namespace dsc {

/// Length of the edge that opens between two junctions, in edge lengths. More than the length below
/// which junctions exchange their neighbours (junctions.cpp).
inline constexpr double opened_length = 0.25;

/// Takes sectors away from the vertex, one at a time, until those that are left are stable or must
/// stay together; an event tells of each. Ties go to the smaller phase, and then to the ray that
/// points farthest to the left. A curve that is left in a corner of the domain, and lies nearly
/// along a side of the domain there, goes on along that side. O(degree squared).
template <class Real>
void split_junction(TopologyWork<Real>& work, Vertex v);

/// The same, and what is left in a corner goes on along the domain boundary beside which `lost` is,
/// if the curve becomes shorter by that.
template <class Real>
void pass_corner(TopologyWork<Real>& work, Vertex corner, Phase lost);

} // namespace dsc
