// SPDX-License-Identifier: MIT
// Mends what changes of topology leave slender, before anything moves.
#pragma once

#include "topology/region.h"

namespace dsc {

/// Mends the slender triangles in the star of a vertex: flips edges, and removes or moves vertices
/// inside phases, as long as that is better. Returns whether it did anything; the vertex need not
/// be alive. No interface vertex moves, so that all phases keep their areas. O(degrees).
template <class Real>
bool mend_star(TopologyWork<Real>& work, Vertex v);

/// Collapses into a vertex the interface vertices that sheets join to it with less than a tenth of
/// the edge length, or a fifth on seams at rest, unless that leaves much flatter triangles:
/// vertices on one curve, features only into junctions and ends of curves. The next vertex of the
/// curve moves as far as keeps the areas of both phases; a sheet without such a vertex stays.
/// O(degrees).
template <class Real>
void collapse_short_sheets(TopologyWork<Real>& work, Vertex v);

/// Whether the vertex is a junction between seams at rest, with narrow triangles. Only reads; false
/// for a dead vertex. O(degree).
template <class Real>
[[nodiscard]] bool has_narrow_seam(const TopologyWork<Real>& work, Vertex v);

/// Mends the narrow triangles of such a junction, to which remeshing does not come any more. If the
/// seams on both sides of a phase are nearly one before they meet, the phase ends in a needle: its
/// tip is cut off where they are, so that the junction moves there. O(degrees).
template <class Real>
void mend_seams(TopologyWork<Real>& work, Vertex v);

} // namespace dsc
