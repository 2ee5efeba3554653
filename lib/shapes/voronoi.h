// SPDX-License-Identifier: MIT
// Voronoi diagrams: scenes of many grains or bubbles. A point belongs to the cell of the site that
// is nearest to it.
#pragma once

#include "dsc/initial/initial_complex.h"

#include <span>
#include <vector>

namespace dsc::scenes {

/// The Voronoi diagram of the sites, clipped to the domain, as curves for `initial_complex`: one
/// straight curve for each edge, and none for the sides of the domain. The cell of site i has the
/// phase i + 1. Vertices are bitwise equal in all curves that meet there.
///
/// Edges shorter than `shortest`, in units of the coordinates, and such pieces of the domain's
/// sides, are contracted: their ends become one vertex in their middle, at which four or more cells
/// may meet; more than two such ends become one vertex at their mean; a vertex that contains a
/// corner of the domain becomes that corner. An edge stays where a cell would lose its third side
/// or would not be seen as a whole from its centre any more. Short edges make small triangles: a
/// third of the mesh's edge length avoids these.
///
/// O(n log n). Throws InputError where sites coincide, up to 2e-9 of the domain; and where it is
/// not certain which cells meet: at a vertex at a corner of the domain, or at several vertices that
/// are nearly one.
[[nodiscard]] std::vector<Curve>
voronoi_curves(const Rectangle& domain, std::span<const Point<double>> sites, double shortest = 0);

/// Moves each site to the centroid of its cell, that many times (S. P. Lloyd, "Least squares
/// quantization in PCM", 1982): cells become rounder and edges longer. O(n log n) a round.
/// Throws InputError for sites as above.
[[nodiscard]] std::vector<Point<double>>
relaxed_sites(const Rectangle& domain, std::span<const Point<double>> sites, int rounds);

/// Random points, evenly distributed and independent; the same with every compiler.
[[nodiscard]] std::vector<Point<double>> random_sites(const Rectangle& domain, std::size_t count,
                                                      std::uint64_t seed);

} // namespace dsc::scenes
