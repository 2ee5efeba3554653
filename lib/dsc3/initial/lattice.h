// SPDX-License-Identifier: MIT
// A lattice over a box, and its refinement.
#pragma once

#include "dsc3/initial/initial_complex.h"
#include "dsc3/operations/workspace.h"

namespace dsc3::initial {

/// Cubes, or nearly so, of six tets each: four or more along the shortest side of the box.
[[nodiscard]] Complex lattice(const Box& domain);

/// The longest edge that a tet may have, from the places of its vertices.
using LongestEdge = std::function<Real(const std::array<Point, 4>&)>;

/// Bisects tets at their longest edges until none has an edge longer than it may. The vertices of
/// the complex end up on the interface of no phase. O(tets).
void refine(Complex& complex, Workspace& work, const LongestEdge& longest);

} // namespace dsc3::initial
