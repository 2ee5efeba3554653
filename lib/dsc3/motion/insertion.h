// SPDX-License-Identifier: MIT
// Positions of new interface vertices.
#pragma once

#include "dsc3/operations/workspace.h"

#include <array>
#include <functional>

namespace dsc3 {

/// The position of a new vertex on the interface edge from a to b. Vertices that have not arrived
/// are at their targets during the call, so tets beside them may be inverted.
using InsertionFunction =
    std::function<Point(const Complex& complex, Workspace& work, std::uint32_t a, std::uint32_t b)>;

/// The middle of the edge's cubic in the curved triangles through the vertices and normals at both
/// ends (A. Vlachos et al., "Curved PN triangles", 2001), scaled such that it lies on a sphere
/// through them if there is one; at most a fifth of the edge's length from its middle. The two ends
/// contribute their harmonic mean, so that it does not overshoot where the curvature changes along
/// the edge (S. Amat et al., "Analysis of a new nonlinear subdivision scheme", 2006). If the sheet
/// ends at a junction curve at one end, the next vertex beyond the other end takes its place, where
/// the curvature is less, and the offset is at most a tenth. On a junction curve: on the cubic
/// through the four vertices around the edge. Returns the middle of the edge if the interface turns
/// to different sides at its ends, or its normals point away from each other.
[[nodiscard]] Point curved_middle(const Complex& complex, Workspace& work, std::uint32_t a,
                                  std::uint32_t b);

} // namespace dsc3
