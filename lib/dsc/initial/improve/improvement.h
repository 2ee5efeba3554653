// SPDX-License-Identifier: MIT
// Better triangles near the interface, with all edges kept constrained Delaunay and the interface
// kept as it is: rounds of relaxation.h and refinement.h.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/initial/improve/refinement.h"

#include <span>

namespace dsc::initial {

struct Improvement {
    std::size_t moves = 0;
    std::size_t collapses = 0;
    std::size_t insertions = 0;
    int rounds = 0;
};

/// Improves the triangles around the given vertices of the interface, in rounds, until nothing
/// improves any more. O(vertices near the interface) a round.
template <class Real>
Improvement improve(Complex<Real>& complex, std::span<const std::uint32_t> interface_vertices,
                    double edge_length, int rounds, Protection protection = Protection::circle);

} // namespace dsc::initial
