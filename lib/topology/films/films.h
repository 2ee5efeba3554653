// SPDX-License-Identifier: MIT
// Films of a phase between two sheets of the interface. Where one is thinner than the contact
// distance it opens: two of its triangles, one at each sheet, are given to the phases beyond, which
// makes a bridge as wide as an edge. From there the seam goes on to both sides, triangle by
// triangle, to where the film is thicker: as at the notch between two drops that merge. A neck that
// closes is the same, seen from the phase that is thin. An option stops the seam at the bridge.
//
// A film whose sheets are parallel opens in several places at once. That is one event: what lies
// between two of these places is thin all along, and the film's seam goes on over it, in this
// sub-step or in one of the next.
//
// A film opens only while it loses area, or where it holds up the interface. In a flow that keeps
// areas two sheets never meet: what becomes thin there is a filament that is being drawn out, and
// it is not cut, however thin it gets.
//
// Not every thin triangle is a film: three successive vertices of one flat curve span one as well,
// and so do the end of a filament and a sharp corner. So a film opens only where two edges face
// each other and are far from each other along the outline, and a seam only goes on where it has
// begun. A sharp notch whose two sides hold up each other closes from its point, as the end of a
// seam does.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Opens films among the triangles at the candidates, in an order that depends only on where they
/// lie. `notable`: those of them that face a sheet or are sharp; the others count once something
/// has changed. O(their degrees), plus the length of the outline for each that opens.
template <class Real>
void open_films(TopologyWork<Real>& work, std::span<const Candidate> candidates,
                std::span<const Candidate> notable);

} // namespace dsc
