// SPDX-License-Identifier: MIT
// Films of a phase between the interface and the domain boundary, which counts as another sheet.
// Where a film is thinner than the contact distance, and squeezed (`Opening::squeezed`), it is
// given to the phase beyond the interface, which then borders on the domain boundary; the interface
// ends on the boundary at both ends of the opened film. The wedge at the end of a curve is the
// matter of landing.h.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Opens films along the domain boundary at the candidates, in an order that depends only on
/// positions. O(candidates * contact / edge length).
template <class Real>
void open_boundary_films(TopologyWork<Real>& work, std::span<const Candidate> candidates);

} // namespace dsc
