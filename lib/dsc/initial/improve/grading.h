// SPDX-License-Identifier: MIT
// A first complex whose edges grow away from the interface: Delaunay refinement of a coarse lattice
// (J. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation", 1995)
// until no triangle is larger than the targets of its vertices allow, and then better triangles.
#pragma once

#include "dsc/initial/improve/centres.h"
#include "dsc/sizes/options.h"

namespace dsc::initial {

struct Grading {
    std::size_t insertions = 0;
    std::size_t collapses = 0;
    std::size_t moves = 0;
    int rounds = 0; ///< of improvement
};

/// Breaks up the triangles that are too large, splits the sides of the domain where they are too
/// long, and improves the triangles in at most so many rounds. The interface stays as it is; all
/// edges stay constrained Delaunay. O(n log n) for the n vertices that there are in the end.
template <class Real>
Grading grade(Complex<Real>& complex, const SizeOptions<Real>& sizes, Real edge_length, int rounds,
              Protection protection = Protection::circle);

} // namespace dsc::initial
