// SPDX-License-Identifier: MIT
// Leaves out points of the interface that are too close together for the mesh: detail below the
// edge length would give permanent needles. Vertices are removed at the shortest edges first
// (compare M. Visvalingam, J. D. Whyatt, "Line generalisation by repeated elimination of points",
// 1993), so that ends of curves, and all points at long edges, stay as they are. If that would
// change areas or the shape too much, the ends of a short edge become one point.
#pragma once

#include "dsc/initial/initial_complex.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dsc::initial {

/// Points at edges shorter than this times the edge length are left out. Below it, triangles beside
/// an edge grow by more than the mesh can follow once the interface moves.
inline constexpr double finest_edge = 0.2;
/// A left-out point lies no farther than this times the edge length from the edge that replaces it:
/// half of the finest edge, so that a tooth of two such edges can be removed.
inline constexpr double max_deviation = 0.1;
/// The area inside a closed curve changes by less than this times its area, and by less than this
/// times the edge length and the length of the curve; that beside an open one by less than half of
/// the latter, so that the area between curves, if it is two edge lengths wide or more, changes by
/// less than this times itself. On a smooth curve this also bounds the deviation to about this
/// times the edge length.
inline constexpr double max_area_change = 1e-3;

/// A line of points that has no point in common with others but its ends.
struct Strand {
    std::span<const Point<double>> points; ///< a closed one repeats its first point at the end
    bool keeps_ends = false;               ///< false: closed, and free to begin at any point
};

/// A point that is left.
struct Kept {
    std::uint32_t index; ///< of the given point, or of the first of those merged into this one
    Point<double> place; ///< within `box`, and rounded to `Real`
};

/// The remaining points of each strand; the caller closes closed ones. The resulting strands have
/// no new common points. Counts left-out points in `report`. O(n log n) for n points at about the
/// same distance.
template <class Real>
std::vector<std::vector<Kept>> thin(std::span<const Strand> strands, const Rectangle& box,
                                    double edge_length, InputReport& report);

/// Whether a closed outline is too small for the mesh, because no two of its points are an edge
/// length apart. Adds it to `report` then. Throws InputError instead if detail is to be kept.
[[nodiscard]] bool is_dropped(std::span<const Point<double>> outline, const std::string& name,
                              const InitialOptions& options, InputReport& report);

} // namespace dsc::initial
