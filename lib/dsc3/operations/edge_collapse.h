// SPDX-License-Identifier: MIT
// Edge collapse: a vertex vanishes into another one, which does not move.
#pragma once

#include "dsc3/operations/workspace.h"

#include <limits>

namespace dsc3 {

/// What a collapse must leave behind. It must raise the worst quality of the star as well, unless
/// that is above `enough` then.
struct CollapseRules {
    Real floor = 1e-3;  ///< the worst quality of the star afterwards lies above
    Real enough = 0.25; ///< a worst quality that is good enough, whatever it was before
    Real min_cos = 0.8; ///< of the angle by which a face of the interface turns
    Real deviation = std::numeric_limits<Real>::infinity(); ///< see below
};

/// Whether `vanishing` may vanish into `target`. A vertex of the interface may along an edge of the
/// interface that is a sheet at both ends, if the interface remains a manifold (the link condition:
/// the ends have two neighbours in common), and if it lies no farther than `rules.deviation` from
/// the interface without it. `work` then holds the collapse. O(degree).
[[nodiscard]] Verdict edge_collapse_guard(const Complex& complex, Workspace& work, Vertex vanishing,
                                          Vertex target, const CollapseRules& rules = {});

/// Collapses if that is legal. O(degree).
Verdict edge_collapse(Complex& complex, Workspace& work, Vertex vanishing, Vertex target,
                      const CollapseRules& rules = {});

} // namespace dsc3
