// SPDX-License-Identifier: MIT
// The order of elimination: nested dissection (A. George, "Nested dissection of a regular finite
// element mesh", 1973) by cuts along the axes.
#pragma once

#include "fluid/field/snapshot_field.h"

#include <vector>

namespace dsc {

/// A part of the mesh: a few triangles, or two halves. Its inner nodes belong to no triangle
/// outside the part and, if the part is cut, to both halves.
struct MeshPart {
    std::uint32_t first_triangle = 0;                  ///< in `Dissection::triangles`
    std::uint32_t triangle_count = 0;                  ///< of both halves
    std::uint32_t first_node = 0;                      ///< in `Dissection::nodes`
    std::uint32_t node_count = 0;                      ///< inner nodes
    std::uint32_t depth = 0;                           ///< 0: the whole
    std::array<std::uint32_t, 2> halves{no_id, no_id}; ///< parts; `no_id`: not cut any further
};

/// A mesh that is bisected recursively.
struct Dissection {
    std::vector<MeshPart> parts = {}; ///< halves before the whole; the last one is the mesh
    std::vector<std::uint32_t> triangles = {}; ///< numbers of the mesh's triangles, part by part
    std::vector<std::uint32_t> nodes =
        {}; ///< each node of a triangle once, in the order of the parts
};

/// Cuts at the median along the longer axis; parts with many triangles try both axes and keep the
/// shorter cut. Then straightens the cut. The result depends only on the mesh. O(n log n).
[[nodiscard]] Dissection dissect(const MeshSnapshot& mesh);

} // namespace dsc
