// SPDX-License-Identifier: MIT
// Films of a phase between the interface and the domain boundary: the domain boundary counts as
// another sheet. Where one is thinner than the contact distance, and squeezed, it is given to the
// phase beyond the interface, which borders on the domain boundary from then on; the interface ends
// on the domain boundary at both sides. The wedge at the end of a curve is left to landing.h.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Opens films along the domain boundary, among the candidates, in an order that depends only on
/// where they lie. O(candidates * contact / edge length).
template <class Real>
void open_boundary_films(TopologyWork<Real>& work, std::span<const Candidate> candidates);

} // namespace dsc
