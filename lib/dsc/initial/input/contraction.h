// SPDX-License-Identifier: MIT
// Merges junctions of a coverage that are too close to each other for the mesh. Voronoi cells have
// such pairs: four cells that nearly meet in a point.
#pragma once

#include "dsc/initial/input/line.h"

#include <vector>

namespace dsc::initial {

/// Contracts lines between two junctions that are shorter than `finest_edge` times the edge length
/// to a point between them, the shortest first: to the end on a side of the domain, if there is
/// one. No junction moves farther than `max_deviation` times the edge length, and no new contacts
/// of lines arise. A region whose whole border is contracted vanishes, which the report counts as
/// dropped; merged junctions count as points left out. O(n log n) for n points at distances that do
/// not differ much.
template <class Real>
void contract_short_lines(std::vector<Line>& lines, const Lattice& lattice, double edge_length,
                          InputReport& report);

} // namespace dsc::initial
