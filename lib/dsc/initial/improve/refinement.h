// SPDX-License-Identifier: MIT
// More vertices where triangles are poor or edges long, by J. Ruppert, "A Delaunay refinement
// algorithm for quality 2-dimensional mesh generation" (1995), with the outlines left as they are.
#pragma once

#include "dsc/initial/improve/centres.h"

#include <span>

namespace dsc::initial {

/// Breaks up poor triangles by the centres of their circles, as long as these do not crowd the
/// interface: new edges are no shorter than those that there are (with `lens`: not by much), and
/// grow with the distance from the short ones. Returns the number of new vertices.
template <class Real>
std::size_t refine(Complex<Real>& complex, std::span<const std::uint32_t> zone,
                   Protection protection = Protection::circle);

/// Splits inner edges that are much longer than the target. Returns the number of new vertices.
template <class Real>
std::size_t split_long(Complex<Real>& complex, std::span<const std::uint32_t> zone,
                       double edge_length);

} // namespace dsc::initial
