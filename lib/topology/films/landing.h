// SPDX-License-Identifier: MIT
// The wedge at the end of a curve, between the curve and the domain boundary that it ends on, or
// another curve of the junction, is thin near that end. It is no film, however small its angle. But
// where the flow presses the curve against the other side, vertex after vertex would be blocked:
// each lands there, and the end of the curve moves on.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Lands the vertices that are blocked next to the end of their curve, among the candidates, in an
/// order that depends only on where they lie; those between them and the end land first. A slit
/// whose mouth holds a vertex up is filled. O(candidates); O(1) where nothing is blocked.
template <class Real>
void land_vertices(TopologyWork<Real>& work, std::span<const Candidate> candidates);

} // namespace dsc
