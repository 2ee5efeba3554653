// SPDX-License-Identifier: MIT
// Makes room for a junction that leaves its vertex: a new vertex nearby, inside a sector or on the
// domain boundary beside it, which takes over all edges of the sector from the old vertex. It is so
// near that all triangles stay positive.
#pragma once

#include "dsc/complex/submesh.h"
#include "topology/junctions/sectors.h"

namespace dsc {

/// Leaves two triangles of the sector at `v`, one on either side of an edge to a new vertex, which
/// is at most `length` away. Returns the corner at `v` of the first; no_id if the sector is too
/// wide, or its only triangle ends at an oblique side, on which no midpoint lies. O(degree
/// squared).
template <class Real>
[[nodiscard]] Corner open_inside(Complex<Real>& complex, Vertex v, const Sector<Real>& sector,
                                 Real length);

/// Leaves one triangle of a sector beside the domain boundary, with a new vertex on the domain
/// boundary. `is_first`: the sector begins with the domain boundary, else it ends there. Returns
/// the corner at `v`; no_id if no place near by lies exactly on the domain boundary. O(degree
/// squared).
template <class Real>
[[nodiscard]] Corner open_on_boundary(Complex<Real>& complex, Vertex v, const Sector<Real>& sector,
                                      bool is_first, Real length);

} // namespace dsc
