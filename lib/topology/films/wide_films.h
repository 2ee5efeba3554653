// SPDX-License-Identifier: MIT
// Films that open at a contact distance of several edge lengths, which no single triangle spans.
// From the middle of each interface edge a ray looks straight into the phases on either side. Where
// it meets another sheet that faces it, nearer than the contact distance, the film is thin.
//
// Rays of neighbouring edges, and of edges that see each other, are one thin place. It opens as a
// whole, as one event, if the flow squeezes it and its sheets are different parts of the outline:
// a round end, a convex corner and a sharp tip are thin as well, but their sheets meet close by.
// A long tip becomes thinner all the way to its point, a film does not.
//
// In later sub-steps the seam grows into the parts of the film beside it that have become thin. At
// its end the interface crosses the film, straight but for the mesh: the error of the area is of
// the order of an edge length times the contact distance.
//
// Sheets that meet at more than 70 degrees do not face each other: a wide notch stays as it is.
//
// The rays miss nothing that is longer than an edge. Two sheets that bend away from each other more
// sharply than the film is thick, as two small drops do, count as squeezed a little later.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Opens the films at the candidates for whose phases the contact distance is wide (`is_wide`), in
/// an order that depends only on where they lie. O(candidates times the contact distance over the
/// edge length), plus the length of the outline for each that opens.
template <class Real>
void open_wide_films(TopologyWork<Real>& work, std::span<const Candidate> candidates);

} // namespace dsc
