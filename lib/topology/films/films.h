// SPDX-License-Identifier: MIT
// Films of a phase between two sheets of the interface. A film thinner than the contact distance
// opens: two of its triangles, one at each sheet, are given to the phases beyond, which makes a
// bridge as wide as an edge. From there the seam extends to both sides, triangle by triangle, up to
// where the film is thicker, such as at the notch between two drops that merge. A neck that closes
// is the same event, seen from the thin phase. With an option the seam stops at the bridge.
//
// A film whose sheets are parallel opens in several places at once. That is one event: the parts
// between these places are thin as well, and the film's seam extends over them, in this sub-step or
// in one of the next.
//
// A film opens only while it loses area, or where it blocks the interface. In a flow that keeps
// areas two sheets never meet: a phase that becomes thin there is a filament that is being
// stretched, which is not cut, however thin it gets.
//
// Not every thin triangle is a film: there are thin triangles between three successive vertices of
// a flat curve, at the end of a filament, and at a sharp feature. So a film opens only where two
// edges face each other and are far from each other along the outline, and a seam only extends from
// where it has begun. A sharp notch whose two sides block each other closes from its tip, as the
// end of a seam does.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Opens films among the triangles at the candidates, in an order that depends only on positions.
/// `notable`: the candidates that face a sheet or are sharp; the others count only once something
/// has changed. O(degrees), plus the length of the outline for each film that opens.
template <class Real>
void open_films(TopologyWork<Real>& work, std::span<const Candidate> candidates,
                std::span<const Candidate> notable);

} // namespace dsc
