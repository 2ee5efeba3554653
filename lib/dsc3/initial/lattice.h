// SPDX-License-Identifier: MIT
// A lattice over a box, and its refinement.
#pragma once

#include "dsc3/initial/initial_complex.h"
#include "dsc3/operations/workspace.h"

namespace dsc3::initial {

/// A lattice of near-cubes of six tets each: four or more along the shortest side of the box.
[[nodiscard]] Complex lattice(const Box& domain);

/// The largest allowed edge length of a tet with vertices at these points.
using LongestEdge = std::function<Real(const std::array<Point, 4>&)>;

/// Bisects tets at their longest edges until no edge is longer than allowed. Clears the interface
/// flags of all vertices. Throws InputError as soon as it expects more than `max_tets`. O(tets).
void refine(Complex& complex, Workspace& work, const LongestEdge& longest, Real max_tets);

} // namespace dsc3::initial
