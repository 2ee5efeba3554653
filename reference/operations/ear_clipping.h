// SPDX-License-Identifier: MIT
// Ear clipping of a simple polygon: thesis, section 7.3 and figure 7.4, after G. H. Meisters,
// "Polygons have ears" (1975).
#pragma once

#include "dsc/base/types.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace dsc::reference {

/// Triangulates a simple counter-clockwise polygon by a walk from its first vertex: an ear is cut
/// off and the walk continues with its successor; other vertices are skipped. A vertex is an ear if
/// the polygon turns strictly left there and no other vertex of the polygon lies in the closed
/// triangle. Returns triangles of polygon indices, all strictly positive, or nothing if a whole
/// round cuts off no ear or the last triangle has no area. O(n^3), exact.
std::optional<std::vector<std::array<std::size_t, 3>>>
ear_clipping(std::span<const Point<double>> polygon);

} // namespace dsc::reference
