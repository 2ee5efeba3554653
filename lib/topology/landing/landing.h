// SPDX-License-Identifier: MIT
// Landing. At the end of a curve there is a wedge between the curve and the domain boundary on
// which it ends, or another curve of the junction. The wedge is thin near that end, but no film,
// however small its angle. If the flow presses the curve against the other side of the wedge,
// vertex after vertex would be blocked there: instead each vertex lands on the other side, and the
// end of the curve moves on.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Lands the junctions that are all but on a side of the domain: they become vertices of it. Where
/// a front leans back from the side, its junction with another front, the end of a seam, arrives
/// there before the rest of it. Before films at the boundary open, because the film beyond such a
/// junction would go to the wrong front. O(candidates).
template <class Real>
void land_junctions(TopologyWork<Real>& work, std::span<const Candidate> candidates);

/// Lands the candidates that are blocked close to the end of their curve, or have all but reached
/// its end on the domain boundary, in an order that depends only on positions; vertices between
/// them and the end land first. A slit whose mouth blocks a vertex is filled. O(candidates).
template <class Real>
void land_vertices(TopologyWork<Real>& work, std::span<const Candidate> candidates);

} // namespace dsc
