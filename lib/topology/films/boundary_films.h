// SPDX-License-Identifier: MIT
// Films of a phase between the interface and the domain boundary, which counts as another sheet.
// Where a film is thinner than the contact distance, and squeezed (`Opening::squeezed`), it is
// given to the phase beyond the interface, which then borders on the domain boundary; the interface
// ends on the boundary at both ends of the opened film. The wedge at the end of a curve is the
// matter of landing.h.
#pragma once

#include "topology/films/chords.h"
#include "topology/region.h"

#include <vector>

namespace dsc {

/// Opens films along the domain boundary that the chords to it cross, in their order; other chords
/// are left out. O(chords * contact / edge length).
template <class Real>
void open_boundary_films(TopologyWork<Real>& work, std::vector<Chord<Real>> chords);

} // namespace dsc
