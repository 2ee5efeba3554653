// SPDX-License-Identifier: MIT
// Voronoi diagrams, for scenes of many grains or bubbles. A point belongs to the cell of the
// nearest site.
#pragma once

#include "dsc/initial/initial_complex.h"

#include <span>
#include <vector>

namespace dsc::scenes {

/// The Voronoi diagram of the sites, clipped to the domain, as curves for `initial_complex`: one
/// straight curve for each edge, and none for the sides of the domain. The cell of site i has the
/// phase i + 1. Vertices are bitwise equal in all curves that meet there.
///
/// Edges, and pieces of the domain's sides, that are shorter than `shortest` (in units of the
/// coordinates) are contracted: their ends become one vertex in the middle, where four or more
/// cells may meet. More than two ends become one vertex at their mean; a vertex that contains a
/// corner of the domain is placed at that corner. An edge is kept if a cell would lose its third
/// side or would no longer be star-shaped about its centre. Short edges cause small triangles,
/// which a third of the mesh's edge length avoids.
///
/// O(n log n). Throws InputError if sites coincide up to 2e-9 of the domain, or if rounding decides
/// which cells meet: at a vertex at a corner of the domain, or at several nearly equal vertices.
[[nodiscard]] std::vector<Curve>
voronoi_curves(const Rectangle& domain, std::span<const Point<double>> sites, double shortest = 0);

/// Moves each site to the centroid of its cell, `rounds` times (S. P. Lloyd, "Least squares
/// quantization in PCM", 1982): cells become rounder and edges longer. O(n log n) for each round.
/// Throws InputError for sites as above.
[[nodiscard]] std::vector<Point<double>>
relaxed_sites(const Rectangle& domain, std::span<const Point<double>> sites, int rounds);

/// Independent, uniformly distributed random points; the same with every compiler.
[[nodiscard]] std::vector<Point<double>> random_sites(const Rectangle& domain, std::size_t count,
                                                      std::uint64_t seed);

} // namespace dsc::scenes
