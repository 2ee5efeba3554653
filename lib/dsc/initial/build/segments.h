// SPDX-License-Identifier: MIT
// Makes the pieces of the interface edges: edges that cross a missing piece are flipped until none
// is left (S. W. Sloan, "A fast algorithm for generating constrained Delaunay triangulations",
// 1993).
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/initial/build/chains.h"

#include <vector>

namespace dsc::initial {

/// Makes each link of the chains an edge. A vertex that lies exactly on a link becomes part of the
/// chain. Links must not cross. Returns the vertices around which edges were flipped: there the
/// triangulation may not be Delaunay any more. O(crossed edges) for each missing link, if they are
/// few.
template <class Real>
std::vector<std::uint32_t> recover_segments(Complex<Real>& complex, Chains& chains);

} // namespace dsc::initial
