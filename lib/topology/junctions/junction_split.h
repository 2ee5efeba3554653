// SPDX-License-Identifier: MIT
// Splits an unstable junction, a vertex with too many sectors, in the way that lowers the energy of
// the interface the most: a junction moves from it into one of its sectors, or the end of a curve
// moves from it along the domain boundary.
#pragma once

#include "topology/junctions/sectors.h"

namespace dsc {

/// Length of the edge that opens between two junctions, in edge lengths. Above the length of a T1
/// (junctions.cpp).
inline constexpr double opened_length = 0.25;

/// Removes sectors from the vertex, one at a time, until the others are stable or must stay
/// together; reports an event for each. Ties go to the smaller phase, and then to the ray that
/// points farthest to the left. If a curve remains in a corner of the domain, and lies nearly along
/// a side there, its end moves on along that side. O(degree squared).
template <class Real>
void split_junction(TopologyWork<Real>& work, Vertex v);

/// Removes the sector of a film from a vertex with four: the phases on both sides of it meet.
template <class Real>
void leave_film(TopologyWork<Real>& work, Vertex v, Phase film);

/// The same; a curve that remains in the corner moves on along the side of the domain at which
/// `lost` lies, if that makes it shorter.
template <class Real>
void pass_corner(TopologyWork<Real>& work, Vertex corner, Phase lost);

} // namespace dsc
