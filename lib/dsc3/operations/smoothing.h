// SPDX-License-Identifier: MIT
// Smoothing: moves a vertex inside a phase, or along the sides of the domain on which it is, to
// improve the worst tet of its star.
#pragma once

#include "dsc3/operations/workspace.h"

namespace dsc3 {

/// Increases the worst quality of the star by at most `iterations` steps of gradient ascent, from
/// the vertex's position or from the mean of its neighbours. A vertex that could not be improved is
/// not tried again until its star changes. O(degree).
Verdict smooth(Complex& complex, Workspace& work, Vertex vertex, int iterations = 6);

/// Conditions of `smooth_along_interface`. Lengths are in units of the domain.
struct AlongRules {
    Real enough = 0;    ///< stars of this quality are not improved further
    Real farthest = 0;  ///< largest move of the vertex
    Real deviation = 0; ///< largest distance of the old position from the new faces, and vice versa
};

/// Moves an interface vertex on the quadric through its neighbours until its star is good enough.
/// The worst quality must rise by a fifth, because the vertex is no marker of the flow afterwards.
/// Refused off a sheet. O(degree).
Verdict smooth_along_interface(Complex& complex, Workspace& work, Vertex vertex,
                               const AlongRules& rules);

// --- for other operations that place a vertex ----------------------------------------------------

/// Moves `place`, the centre of a star, to increase the worst quality, which is `quality` there, as
/// `smooth` does; coordinates in `fixed` (`vertex_fixed_x`, ...) stay. Returns the new worst
/// quality. O(degree).
[[nodiscard]] Real raise_worst(StarQuality& star, Real quality, Point& place, int iterations,
                               std::uint32_t fixed = 0);

} // namespace dsc3
