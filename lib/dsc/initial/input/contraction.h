// SPDX-License-Identifier: MIT
// Merges junctions of a coverage that are too close to each other for the mesh. Voronoi cells have
// such pairs: four cells that nearly meet in a point.
#pragma once

#include "dsc/initial/input/line.h"

#include <vector>

namespace dsc::initial {

/// Contracts lines between two junctions that are shorter than `finest_edge` times the edge length
/// to a point between them, the shortest first: to the end on a side of the domain, if there is
/// one. No junction moves farther than `max_deviation` times the edge length, and lines meet
/// nowhere that they did not meet before. A region all of whose border is contracted vanishes; the
/// report counts it as dropped, and junctions that became one as points that were left out.
/// O(n log n) for n points at distances that do not differ much.
template <class Real>
void contract_short_lines(std::vector<Line>& lines, const Lattice& lattice, double edge_length,
                          InputReport& report);

} // namespace dsc::initial
