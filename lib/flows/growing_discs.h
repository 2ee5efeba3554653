// SPDX-License-Identifier: MIT
// Discs, each of a phase of its own, that grow at a speed of 1 until they fill the unit square (W.
// A. Johnson and R. F. Mehl, 1939). Each point belongs to the disc that reaches it first, which
// gives the additively weighted Voronoi diagram: the exact positions where fronts meet.
#pragma once

#include "dsc/complex/complex.h"
#include "shapes/outline.h"

#include <cstdint>
#include <vector>

namespace dsc::scenes {

/// Disc i is phase i + 1, in phase 0.
struct GrowingDiscs {
    std::vector<Point<double>> centres;
    std::vector<double> radii;  ///< at the start
    std::vector<double> starts; ///< times at which the discs start to grow; empty: 0

    [[nodiscard]] double start(std::size_t i) const { return starts.empty() ? 0 : starts[i]; }

    /// The time at which the front of disc i reaches a point.
    [[nodiscard]] double arrival(std::size_t i, const Point<double>& p) const {
        return start(i) + (p - centres[i]).norm() - radii[i];
    }
};

/// Discs at random positions, drawn from a seed, with distances from each other and from the sides.
/// Seed 0: two or three discs at fixed positions.
[[nodiscard]] GrowingDiscs random_discs(int number, std::uint64_t seed);

/// The same, with additional discs that nucleate at a rate per unit of area and time, at positions
/// that no front reaches soon. They are in the mesh from the start, and begin to grow once a disc
/// growing from a point would have their size.
[[nodiscard]] GrowingDiscs nucleating_discs(int number, std::uint64_t seed, double rate);

/// The time at which the square is full, to within 0.002.
[[nodiscard]] double filling_time(const GrowingDiscs& discs);

/// The region that disc i has filled at a time.
[[nodiscard]] ExactShape exact_cell(const GrowingDiscs& discs, std::size_t i, double time);

/// The errors of a complex relative to the exact diagram.
struct DiagramError {
    double wrong_area = 0;  ///< area of the parts of triangles that belong to another phase
    double phase_error = 0; ///< largest error of the area of a disc
    double seam_max = 0;    ///< largest distance from a seam's vertex to its bisector...
    double seam_rms = 0;    ///< ...and the root of the mean square
    double triple_max = 0;  ///< largest difference between the arrivals of the fronts of a junction
    int triples = 0;        ///< junctions of three fronts or more
};

/// At a time. O(triangles * discs) beside fronts.
template <class Real>
[[nodiscard]] DiagramError diagram_error(const Complex<Real>& complex, const GrowingDiscs& discs,
                                         double time);

} // namespace dsc::scenes
