// SPDX-License-Identifier: MIT
// Flip of an interface edge: the two faces at edge (a, b) with the other vertices c and d become
// the two at edge (c, d); the tets on both sides are replaced.
#pragma once

#include "dsc3/operations/workspace.h"

namespace dsc3 {

/// Conditions of a flip.
struct FlipRules {
    Real floor = 0.1; ///< lower bound of the worst quality, unless it was lower before
    /// Cosine of the largest angle between the normals of the two faces, before and after the flip.
    /// Later splits amplify the change of the interface by the flip of a bent edge: with 0.93 the
    /// errors of vertices after Enright's test are 1.1 to 2.5 times as large.
    Real min_cos = 0.96;
    Real slack = 0.05; ///< of the Delaunay test: only clear violations are flipped
    /// A length: the edge of a cap, a face with a vertex nearly on its longest edge, is flipped
    /// whatever its normal, which is noise, if the diagonals are nearer to each other than this.
    Real cap_gap = 0;
};

/// Whether the edge (a, b) with the opposite vertices c and d clearly violates the Delaunay
/// property on the unfolded interface: the sine of the sum of the opposite angles is negative,
/// relatively by more than `slack`.
[[nodiscard]] bool wants_flip(const Point& a, const Point& b, const Point& c, const Point& d,
                              Real slack);

/// Flips the edge if it has exactly two interface faces between two phases, is not Delaunay and
/// nearly flat, and if the interface remains a manifold. O(degree).
Verdict interface_flip(Complex& complex, Workspace& work, const EdgeAt& edge,
                       const FlipRules& rules = {});

/// Assigns a flat tet (a, b, c, d), whose two faces at (a, b) are on the interface, to the other
/// phase and removes its edge (a, b), which is then inside a phase. Without the removal the change
/// would be reversed again and again. O(degree).
Verdict reassign_sliver(Complex& complex, Workspace& work, const EdgeAt& edge);

} // namespace dsc3
