// SPDX-License-Identifier: MIT
// Films that open at a contact distance of several edge lengths, which no single triangle spans.
// From the middle of each interface edge a ray goes perpendicularly into the phases on either side.
// The film is thin there if the ray meets another sheet that faces the edge within the contact
// distance.
//
// Rays of neighbouring edges, and of edges opposite to each other, form a thin place. The place
// opens as a whole, as one event, if the flow squeezes it and its sheets are different parts of the
// outline: a round end, a convex feature and a sharp tip are thin as well, but their sheets meet
// nearby. A long tip becomes thinner all the way to its point, a film does not.
//
// In later sub-steps the seam extends over the parts of the film beside it that have become thin.
// At the seam's end the interface crosses the film along triangle edges, so the error of the area
// is of the order of an edge length times the contact distance.
//
// Sheets that meet at more than 70 degrees do not face each other: a wide notch stays as it is.
//
// The rays miss no film that is longer than an edge. If two sheets bend away from each other with a
// radius smaller than the thickness of the film, as those of two small drops do, the film counts as
// squeezed slightly later.
#pragma once

#include "topology/candidates.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Opens films at the candidates between phases with a wide contact distance (`is_wide`), in an
/// order that depends only on positions. O(candidates * contact / edge length), plus the length of
/// the outline for each film that opens.
template <class Real>
void open_wide_films(TopologyWork<Real>& work, std::span<const Candidate> candidates);

} // namespace dsc
