// SPDX-License-Identifier: MIT
// Point location inside one phase, and insertion, with the triangulation kept constrained Delaunay
// by flips (C. L. Lawson, "Software for C1 surface interpolation", 1977). An edge is flipped only
// where the in-circle test is certain: each flip lowers the lifted surface, so the flips come to an
// end without a slack.
#pragma once

#include "dsc/complex/walk.h"

#include <vector>

namespace dsc::initial {

/// Whether the star of a vertex has changed since it was last examined; stored in the vertices'
/// `slot` while the complex is built. A star that could not be improved is not tried again.
inline constexpr std::uint32_t unsettled = no_id;
inline constexpr std::uint32_t settled = 0;

/// Restores the Delaunay property after the star of a vertex has changed. Vertices whose stars
/// change are unsettled. `stack` is scratch memory.
template <class Real>
void legalise_star(Complex<Real>& complex, std::uint32_t vertex, std::vector<Corner>& stack);

/// Walks from a living triangle towards the point; `stopped` at an edge of the domain or of the
/// interface. O(triangles on the way).
template <class Real>
WalkEnd locate(const Complex<Real>& complex, std::uint32_t start, const Point<Real>& point);

/// Inserts a vertex at `point`, or returns the one that is there already; restores the Delaunay
/// property. `place` must not be `stopped`. O(degree), except for long chains of flips.
template <class Real>
std::uint32_t insert_point(Complex<Real>& complex, const WalkEnd& place, const Point<Real>& point,
                           std::vector<Corner>& stack);

} // namespace dsc::initial
