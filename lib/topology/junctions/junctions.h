// SPDX-License-Identifier: MIT
// Junctions of the interface. Three phases at a vertex are stable; a vertex with four or more
// sectors is not, and comes apart in the way that lowers the energy of the interface the most. Two
// junctions whose common edge has shrunk away become such a vertex, and exchange their neighbours
// when it comes apart again (the T1 of foams and grains).
//
// The domain boundary is a mirror, and the same happens there: two curves whose ends meet on the
// domain boundary leave it as one, and a junction that reaches the domain boundary becomes the ends
// of two curves. Corners of the domain do not move, and neither does a curve that ends in one,
// until it lies along a side of the domain. So the end of a curve that comes close to a corner is
// put on the other side, if the curve becomes shorter by that, as it does in convex corners. In a
// reentrant one it may stay.
#pragma once

#include "topology/region.h"
#include "topology/suspicion.h"

#include <span>

namespace dsc {

/// Exchanges the neighbours of junctions among the candidates, and takes vertices with more sectors
/// than are stable apart. O(their degrees squared).
template <class Real>
void change_junctions(TopologyWork<Real>& work, std::span<const Candidate> candidates);

/// Takes the vertices of triangles that have changed hands apart where they have more sectors than
/// are stable: films that opened and pieces that vanished may leave such vertices. O(their degrees
/// squared).
template <class Real>
void take_touched_apart(TopologyWork<Real>& work);

} // namespace dsc
