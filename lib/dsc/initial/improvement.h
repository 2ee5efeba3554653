// SPDX-License-Identifier: MIT
// Better triangles near the interface: inner vertices are smoothed, collapsed and inserted, with all
// edges kept constrained Delaunay (W. H. Frey, D. A. Field, "Mesh relaxation", 1991; L. P. Chew,
// "Guaranteed-quality mesh generation for curved surfaces", 1993). The interface stays as it is.
#pragma once

#include "dsc/complex/complex.h"

#include <span>

namespace dsc::initial {

struct Improvement {
    std::size_t moves = 0;
    std::size_t collapses = 0;
    std::size_t insertions = 0;
    int rounds = 0;
};

/// Improves the few rings of triangles around the given vertices of the interface, in rounds, until
/// nothing improves any more. O(vertices near the interface) a round.
template <class Real>
Improvement improve(Complex<Real>& complex, std::span<const std::uint32_t> interface_vertices,
                    double edge_length, int rounds);

} // namespace dsc::initial
