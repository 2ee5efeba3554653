// SPDX-License-Identifier: MIT
// Fronts of different phases that meet. A vertex of one front and its foot on the other, across a
// film, become one vertex where the two meet: on the bisector of their tangents, the gap divided as
// they approach. No triangle changes its phase, so the seam between the fronts is of second order.
// Only where they displace the exterior: `meet_in_points` (region.h).
// The film closes from there outwards, as far as it is thinner than the contact distance or than
// what the fronts approach in a sub-step: one event for each place where fronts meet first. Films
// at sides and within one phase are the matter of boundary_films.h, landing.h and films.h.
#pragma once

#include "topology/region.h"

namespace dsc {

/// Joins the fronts that meet, of all of the interface. The threads of the step search together;
/// edits are serial, in an order that depends on places alone. O(degrees).
template <class Real>
void meet_fronts(TopologyWork<Real>& work);

} // namespace dsc
