// SPDX-License-Identifier: MIT
// Edge collapse: a vertex is merged into another one, which does not move.
#pragma once

#include "dsc3/operations/workspace.h"

#include <limits>

namespace dsc3 {

/// Conditions after a collapse. It must also raise the worst quality of the star, unless the new
/// worst quality is above `enough`.
struct CollapseRules {
    Real floor = 1e-3;  ///< lower bound of the worst quality afterwards
    Real enough = 0.25; ///< no improvement is required above this quality
    Real min_cos = 0.8; ///< cosine of the largest rotation of an interface face
    Real deviation = std::numeric_limits<Real>::infinity(); ///< see below
    /// The same for a vertex of a junction curve.
    Real curve_deviation = std::numeric_limits<Real>::infinity();
    /// Upper bound of the length of the edge that replaces two of a junction curve.
    Real longest_on_curve = std::numeric_limits<Real>::infinity();
};

/// Whether `vanishing` may be merged into `target`. An interface vertex may be removed along an
/// interface edge, if it lies on a sheet, or the edge on its curve, if the interface remains a
/// manifold (the link condition: common neighbours are those of the faces at the edge), and if the
/// vertex lies within `rules.deviation` of the new interface. A vertex on sides of the domain may
/// be removed along them. `work` then holds the collapse. O(degree).
[[nodiscard]] Verdict edge_collapse_guard(const Complex& complex, Workspace& work, Vertex vanishing,
                                          Vertex target, const CollapseRules& rules = {});

/// Collapses if that is legal. O(degree).
Verdict edge_collapse(Complex& complex, Workspace& work, Vertex vanishing, Vertex target,
                      const CollapseRules& rules = {});

} // namespace dsc3
