// SPDX-License-Identifier: MIT
// Flip of an interface edge: the two faces at edge (a, b) with the other vertices c and d become
// the two at edge (c, d); the tets on either side are made anew.
#pragma once

#include "dsc3/operations/workspace.h"

namespace dsc3 {

/// What a flip must leave behind.
struct FlipRules {
    Real floor = 0.1; ///< worst quality of the tets afterwards, or what it was if that is lower
    /// Of the angles between the four faces, the two before and the two after. Later splits carry
    /// on what the flip of a bent edge does to the interface: at 0.93 vertices that come back from
    /// Enright's film are off by 1.1 to 2.5 times as much.
    Real min_cos = 0.96;
    Real slack = 0.05; ///< the edge is clearly not Delaunay on the interface
};

/// Whether the edge (a, b) with the opposite vertices c and d violates the Delaunay property on the
/// interface, unfolded, by more than a little: the sine of the sum of the opposite angles is
/// negative, relative to the product of their sines or more.
[[nodiscard]] bool wants_flip(const Point& a, const Point& b, const Point& c, const Point& d,
                              Real slack);

/// Flips the edge if it is one between exactly two faces and two phases, not Delaunay, nearly flat,
/// and if the interface remains a manifold. O(degree).
Verdict interface_flip(Complex& complex, Workspace& work, const EdgeAt& edge,
                       const FlipRules& rules = {});

/// Gives a flat tet (a, b, c, d) whose two faces at (a, b) are on the interface to the other phase,
/// if its edge (a, b), which is inside a phase then, can be removed. By itself the change would be
/// undone and done again for ever. O(degree).
Verdict reassign_sliver(Complex& complex, Workspace& work, const EdgeAt& edge);

} // namespace dsc3
