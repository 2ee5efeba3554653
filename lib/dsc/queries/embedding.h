// SPDX-License-Identifier: MIT
// A complex whose vertices are all discs or half discs, and whose triangles are all positive, may
// still overlap itself. That no two of its triangles overlap (thesis, chapter 3, condition 2)
// follows from its boundary alone:
//   each component is a sphere with holes (Euler: V - E + T = 2 - loops), and its map to the plane
//   is locally one to one. The number of triangles over a point is then the winding number of the
//   boundary about it. If no two loops meet, and one loop of each component turns left (Hopf: the
//   turning numbers sum up to 2 - loops), that number is 0 or 1 for each component; components are
//   disjoint if no loop of one lies inside another.
#pragma once

#include "dsc/queries/validate.h"

namespace dsc {

/// Describes in words where Euler's formula is violated or the domain overlaps itself; empty if
/// neither is the case. The links, stars and orientations of the complex must be correct. Fills in
/// the report's counts of edges, components and loops. O(n + b log b) for b boundary edges, and
/// O(b) for each loop where there are several components.
template <class Real>
[[nodiscard]] std::string find_overlap(const Complex<Real>& complex, ValidationReport& report);

} // namespace dsc
