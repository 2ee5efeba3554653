// SPDX-License-Identifier: MIT
// A Voronoi diagram by numbers: which cells meet at which vertex. Each vertex is computed once, in
// one way, so that all cells around it agree to the bit.
#pragma once

#include "shapes/cell_clipping.h"

#include <array>
#include <span>
#include <vector>

namespace dsc::scenes {

/// A cell by its vertices, counter-clockwise, and by what lies beyond the edge from vertex k to
/// k + 1: a site or a side of the domain.
struct VoronoiCell {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> beyond;
};

struct VoronoiDiagram {
    Rectangle domain;
    std::vector<Point<double>> sites;
    /// The corners of the domain, counter-clockwise from the lower left one, and then the other
    /// vertices, in the order of the three numbers of the sites and sides that meet there.
    std::vector<Point<double>> vertices;
    /// By vertex, which sides of the domain it lies on: bit k for the side `bottom_side` + k.
    std::vector<std::uint8_t> sides;
    std::vector<VoronoiCell> cells;
};

inline constexpr std::uint32_t domain_corners = 4;

/// The diagram of the sites. O(n log n), and the cost of `clip_cells`. Throws InputError as
/// `clip_cells` does, and where cells disagree on the sites that meet at a vertex.
[[nodiscard]] VoronoiDiagram voronoi_diagram(const Rectangle& domain,
                                             std::span<const Point<double>> sites);

/// Contracts edges, and pieces of the domain's sides, that are shorter than `shortest`, the
/// shortest first, as `VoronoiOptions` says; then edges that this has made too short, until nothing
/// changes. O(n log n) for each of a few rounds.
[[nodiscard]] VoronoiDiagram without_short_edges(VoronoiDiagram diagram, double shortest);

} // namespace dsc::scenes
