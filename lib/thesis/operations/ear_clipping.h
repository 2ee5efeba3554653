// SPDX-License-Identifier: MIT
// Ear clipping (thesis, section 7.3, figure 7.4): a simple polygon cut into triangles, one vertex
// at a time. G. H. Meisters, "Polygons have ears" (1975): there is always an ear to cut, unless
// rounding has made the polygon touch itself.
#pragma once

#include "dsc/base/types.h"

#include <array>
#include <span>
#include <vector>

namespace dsc {

/// The result and the scratch of ear clipping. Reuse one object: calls stop allocating once it has
/// grown.
struct EarClipping {
    /// Indices into the polygon, counter-clockwise, in the order of cutting: the ear in the middle,
    /// between its neighbours at that moment. The last one is the triangle that remained.
    std::vector<std::array<std::uint32_t, 3>> triangles;

    std::vector<std::uint32_t> next; ///< scratch
    std::vector<std::uint32_t> prev; ///< scratch
};

/// Triangulates the counter-clockwise polygon into n - 2 strictly positive triangles. The walk
/// starts at its first vertex; an ear is cut and the walk goes on with its successor. A vertex is
/// an ear if the polygon turns strictly left there and no other vertex of the polygon lies in the
/// closed triangle. Returns false if a whole round cuts nothing or the last triangle is not
/// positive. O(n^3) at worst, usually O(n^2). Exact.
template <class Real>
bool ear_clipping(std::span<const Point<Real>> polygon, EarClipping& work);

} // namespace dsc
