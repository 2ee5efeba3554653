// SPDX-License-Identifier: MIT
// Merges two junctions along the short edge between them.
#pragma once

#include "topology/region.h"

namespace dsc {

/// Collapses the edge between two vertices into one of them, which keeps its position, and returns
/// it: `w`, or with `either` the one that leaves the better triangles. Vertices inside a phase that
/// would leave flat triangles are removed first. Returns no vertex if the triangles about the edge
/// prevent the collapse. O(degree), a few times.
template <class Real>
[[nodiscard]] Vertex merge_ends(TopologyWork<Real>& work, Vertex v, Vertex w, bool either);

/// Collapses a vertex inside a phase into the neighbour that leaves the best triangles. Returns
/// false if no collapse leaves a squared quality above `min_quality`. O(degree squared).
template <class Real>
bool remove_inside(TopologyWork<Real>& work, Vertex vertex, Real min_quality);

} // namespace dsc
