// SPDX-License-Identifier: MIT
// Where a new vertex of the interface belongs.
#pragma once

#include "dsc3/operations/workspace.h"

#include <array>
#include <functional>

namespace dsc3 {

/// The place of a new vertex on the interface edge from a to b.
using InsertionFunction =
    std::function<Point(const Complex& complex, Workspace& work, std::uint32_t a, std::uint32_t b)>;

/// The middle of the edge's cubic in the curved triangles through the vertices and normals at both
/// ends (A. Vlachos et al., "Curved PN triangles", 2001), at most a fifth of the edge's length from
/// its middle. The middle itself if an end is on no sheet, or the normals face away from each
/// other.
[[nodiscard]] Point curved_middle(const Complex& complex, Workspace& work, std::uint32_t a,
                                  std::uint32_t b);

} // namespace dsc3
