// SPDX-License-Identifier: MIT
// Discs of as many phases that grow at a speed of 1 until they fill the unit square (W. A. Johnson
// and R. F. Mehl, 1939). Each place belongs to the disc that reaches it first, which is the
// additively weighted Voronoi diagram: the exact answer to where fronts meet.
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
    std::vector<double> starts; ///< the times from which they grow; empty: from 0

    [[nodiscard]] double start(std::size_t i) const { return starts.empty() ? 0 : starts[i]; }

    /// When the front of disc i reaches a place.
    [[nodiscard]] double arrival(std::size_t i, const Point<double>& p) const {
        return start(i) + (p - centres[i]).norm() - radii[i];
    }
};

/// At random places, drawn from a seed, none near another or the sides. Seed 0: two or three discs
/// at places of their own.
[[nodiscard]] GrowingDiscs random_discs(int number, std::uint64_t seed);

/// The same, and others that nucleate where no front is or soon will be: so many per unit of area
/// and time. They are in the mesh from the start, and begin to grow when they are as large as that.
[[nodiscard]] GrowingDiscs nucleating_discs(int number, std::uint64_t seed, double rate);

/// When the square is full, to within 0.002.
[[nodiscard]] double filling_time(const GrowingDiscs& discs);

/// What disc i has filled at a time.
[[nodiscard]] ExactShape exact_cell(const GrowingDiscs& discs, std::size_t i, double time);

/// How far a complex is from the exact one.
struct DiagramError {
    double wrong_area = 0;  ///< of the triangles' parts that belong to another phase
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
