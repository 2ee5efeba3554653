// SPDX-License-Identifier: MIT
// The global half of validation: a complex whose vertices are all discs or half discs, and whose
// triangles are all positive, may still overlap itself. That no two of its triangles overlap
// (thesis, chapter 3, condition 2) follows from its boundary alone:
//   each component is a sphere with holes (Euler: V - E + T = 2 - loops), and its map to the plane
//   is locally one to one. The number of triangles over a point is then the winding number of the
//   boundary about it. If no two loops meet, and one loop of each component turns left (Hopf: the
//   turning numbers sum up to 2 - loops), that number is 0 or 1 for each component; components are
//   disjoint if no loop of one lies inside another.
#pragma once

#include "dsc/complex/complex.h"

#include <cstdint>
#include <string>

namespace dsc {

/// How a complex with consistent links is connected.
struct Embedding {
    std::uint64_t components = 0;
    std::uint64_t boundary_loops = 0;
    std::uint64_t boundary_edges = 0;
    std::string problem; ///< where two boundary edges meet, or one component overlaps another
};

/// Counts the parts of a complex and looks for overlaps. O(n + b log b) for b boundary edges if few
/// of them lie above each other, as in a rectangle; O(b^2) at worst.
/// \pre links are symmetric, every vertex is a disc or half disc that goes around it once, every
/// triangle is positive.
template <class Real>
[[nodiscard]] Embedding check_embedding(const Complex<Real>& complex);

} // namespace dsc
