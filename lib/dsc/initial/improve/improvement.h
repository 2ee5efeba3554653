// SPDX-License-Identifier: MIT
// Better triangles, with all edges kept constrained Delaunay and the interface kept as it is:
// rounds of relaxation.h and refinement.h, near the interface or, where edges grow, everywhere.
#pragma once

#include "dsc/initial/improve/refinement.h"
#include "dsc/sizes/sizes.h"

#include <span>

namespace dsc::initial {

/// The unsettled vertices within a few edges of the interface, and beyond these wherever short
/// edges have not yet grown to the target; the interface first. O(vertices near the interface).
template <class Real>
std::vector<std::uint32_t> find_zone(Complex<Real>& complex,
                                     std::span<const std::uint32_t> interface_vertices,
                                     double edge_length);

/// Improves the triangles around the given vertices of the interface, in at most `rounds` rounds,
/// until nothing improves any more. O(vertices near the interface) a round.
template <class Real>
void improve(Complex<Real>& complex, std::span<const std::uint32_t> interface_vertices,
             double edge_length, int rounds, Protection protection);

/// Makes the edges of a coarse mesh grow away from the interface: breaks up the triangles that are
/// larger than the targets of their vertices allow, splits the sides of the domain where they are
/// too long, and improves the triangles. O(n log n) for the n vertices that there are in the end.
template <class Real>
void grade(Complex<Real>& complex, const SizeOptions<Real>& sizes, Real edge_length, int rounds,
           Protection protection);

} // namespace dsc::initial
