// SPDX-License-Identifier: MIT
// Takes the short edges out of a Voronoi diagram.
#pragma once

#include "shapes/voronoi_diagram.h"

namespace dsc::scenes {

/// Contracts edges, and pieces of the domain's sides, that are shorter than `shortest`, the
/// shortest first, as `VoronoiOptions` says; then edges that this has made too short, until nothing
/// changes. O(n log n) for each of a few rounds.
[[nodiscard]] VoronoiDiagram without_short_edges(VoronoiDiagram diagram, double shortest);

} // namespace dsc::scenes
