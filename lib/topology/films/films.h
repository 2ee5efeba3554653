// SPDX-License-Identifier: MIT
// Films of a phase between two sheets of the interface, of any thickness: chords.h finds the thin
// places, where rays across the phase are shorter than the contact distance.
//
// A thin place opens as a whole, as one event, if the flow squeezes it and its sheets are different
// parts of the outline: a round end, a convex feature and a sharp tip are thin as well, but their
// sheets meet nearby. A long tip becomes thinner all the way to its point, a film does not. The
// triangles that the rays cross are given to the phases beyond. A neck that closes is the same
// event, seen from the thin phase. With an option only the thinnest part opens, as wide as an edge.
//
// In later sub-steps the seam extends over the parts of the film beside it that have become thin.
// At the seam's end the interface crosses the film along triangle edges, so the error of the area
// is of the order of an edge length times the contact distance. A sharp notch whose two sides block
// each other closes from its tip, as the end of a seam does.
//
// A film opens only while it loses area, or where it blocks the interface. In a flow that keeps
// areas two sheets never meet: a phase that becomes thin there is a filament that is being
// stretched, which is not cut, however thin it gets.
//
// Sheets that meet at more than 70 degrees do not face each other: a wide notch stays as it is.
// Fronts of different phases meet in points instead (meeting.h), unless the contact distance is
// wider than a triangle.
#pragma once

#include "topology/films/chords.h"
#include "topology/region.h"

#include <span>

namespace dsc {

/// Opens the films that the chords cross, in their order, which depends only on positions. Chords
/// to the domain boundary are left out. O(chords * contact / edge length), plus the length of the
/// outline for each film that opens.
template <class Real>
void open_films(TopologyWork<Real>& work, std::span<const Chord<Real>> chords);

} // namespace dsc
