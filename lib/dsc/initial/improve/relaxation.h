// SPDX-License-Identifier: MIT
// Fewer and better placed vertices: smoothing and collapses that are accepted only where the worst
// triangle about a vertex becomes better. Laplacian smoothing where it helps, a search for the best
// place where it does not, as in L. A. Freitag, C. Ollivier-Gooch, "Tetrahedral mesh improvement
// using swapping and smoothing" (1997).
#pragma once

#include "dsc/complex/complex.h"

#include <span>

namespace dsc::initial {

/// Moves those of the given vertices that are unsettled: anywhere inside one phase, and on the
/// domain boundary along its straight sides. Vertices that it does not move become settled. Returns
/// the number of moves. All edges stay constrained Delaunay.
template <class Real>
std::size_t smooth(Complex<Real>& complex, std::span<const std::uint32_t> zone);

/// Collapses such vertices into a neighbour if their triangles are poor and crowded. Returns the
/// number of collapses. All edges stay constrained Delaunay.
template <class Real>
std::size_t thin_out(Complex<Real>& complex, std::span<const std::uint32_t> zone,
                     double edge_length);

} // namespace dsc::initial
