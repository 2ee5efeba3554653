// SPDX-License-Identifier: MIT
// A Voronoi diagram as indices of cells and vertices. Each vertex is computed once, so it is
// bitwise identical in all cells around it.
#pragma once

#include "dsc/initial/initial_complex.h"

#include <span>
#include <vector>

namespace dsc::scenes {

/// The sides of the domain as neighbours of cells, in counter-clockwise order. Their numbers are
/// larger than those of all sites.
inline constexpr std::uint32_t bottom_side = 0xfffffff0U;
inline constexpr std::uint32_t right_side = bottom_side + 1;
inline constexpr std::uint32_t top_side = bottom_side + 2;
inline constexpr std::uint32_t left_side = bottom_side + 3;

inline bool is_side(std::uint32_t beyond) { return beyond >= bottom_side; }

/// A cell: its vertices, counter-clockwise, and its neighbour across the edge from vertex k to k +
/// 1: a site or a side of the domain.
struct VoronoiCell {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> beyond;
};

struct VoronoiDiagram {
    Rectangle domain;
    std::vector<Point<double>> sites;
    /// The corners of the domain, counter-clockwise from the lower left one, and then the other
    /// vertices.
    std::vector<Point<double>> vertices;
    /// By vertex, the sides of the domain on which it lies: bit k for the side `bottom_side` + k.
    std::vector<std::uint8_t> sides;
    std::vector<VoronoiCell> cells;

    [[nodiscard]] std::vector<Point<double>> corners_of(const VoronoiCell& cell) const;
};

inline constexpr std::uint32_t domain_corners = 4;

/// The centroid of a polygon's area. O(corners).
[[nodiscard]] Point<double> centroid(std::span<const Point<double>> corners);

/// Whether the cell is star-shaped about a point: each edge has positive length and runs
/// counter-clockwise around the point. The point may lie on a side of the domain. Exact. Such a
/// cell is a simple polygon.
[[nodiscard]] bool is_seen_from(const Point<double>& point, std::span<const Point<double>> corners,
                                std::span<const std::uint32_t> beyond);

/// The diagram of sites in the domain. O(n log n). Throws InputError for sites that coincide, a
/// vertex at a corner of the domain, and cells that are invalid after rounding of their vertices.
[[nodiscard]] VoronoiDiagram voronoi_diagram(const Rectangle& domain,
                                             std::span<const Point<double>> sites);

/// Contracts edges, and pieces of the domain's sides, that are shorter than `shortest`, the
/// shortest first, as described for `voronoi_curves`; repeats this until nothing changes. O(n log
/// n) for each of a few rounds.
[[nodiscard]] VoronoiDiagram without_short_edges(VoronoiDiagram diagram, double shortest);

} // namespace dsc::scenes
