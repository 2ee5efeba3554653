// SPDX-License-Identifier: MIT
// Junctions of the interface. Three phases at a vertex are stable; a vertex with four or more
// sectors is not, and splits in the way that lowers the energy of the interface the most. Two
// junctions whose common edge has shrunk away become such a vertex, and exchange their neighbours
// when it splits again (the T1 of foams and grains).
//
// The domain boundary acts as a mirror: two curves whose ends meet on it leave it as one curve, and
// a junction that reaches it becomes the ends of two curves. Corners of the domain do not move, and
// neither does the end of a curve in a corner, until the curve lies along a side of the domain.
// Therefore the end of a curve that comes close to a corner is moved past it if that makes the
// curve shorter, as at convex corners. In a reentrant corner it may stay.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <cstddef>
#include <span>

namespace dsc {

/// Performs T1s between junctions among the candidates, and splits vertices with more sectors than
/// are stable. O(their degrees squared).
template <class Real>
void change_junctions(TopologyWork<Real>& work, std::span<const Candidate> candidates);

/// Splits vertices of relabelled triangles that have more sectors than are stable: films that
/// opened and pieces that vanished may leave such vertices. What the changes have left slender
/// around the touched vertices from `first_mended` on, and around those of splits, is then mended,
/// because the step may end here; and so is what movement has left slender at junctions and ends of
/// curves, which may run faster than anything else. O(their degrees squared).
template <class Real>
void split_touched(TopologyWork<Real>& work, std::span<const Candidate> candidates,
                   std::size_t first_mended);

} // namespace dsc
