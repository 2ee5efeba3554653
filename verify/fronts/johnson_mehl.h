// SPDX-License-Identifier: MIT
// Discs of different phases that grow at a speed of 1 until the unit square is full (W. A. Johnson
// and R. F. Mehl, 1939). The exact result is the additively weighted Voronoi diagram: each point
// belongs to the disc that reaches it first. It measures how accurately fronts meet.
#pragma once

#include "dsc/complex/complex.h"
#include "topology/events.h"

#include <map>
#include <vector>

namespace dsc::fronts {

/// Disc i is phase i + 1, in phase 0.
struct Discs {
    std::vector<Point<double>> centres;
    std::vector<double> radii;

    /// The time at which the front of disc i reaches a point.
    [[nodiscard]] double arrival(std::size_t i, const Point<double>& p) const {
        return (p - centres[i]).norm() - radii[i];
    }
};

/// Discs at random places drawn from a seed, away from each other and from the sides. Seed 0: two
/// or three discs at fixed places.
[[nodiscard]] Discs discs_of(int number, std::uint64_t seed);

/// The errors of a complex.
struct Distance {
    double wrong_area = 0;  ///< area of the parts of triangles that belong to another phase
    double phase_error = 0; ///< largest error of the area of a disc
    double seam_max = 0;    ///< largest distance from a seam's vertex to its bisector...
    double seam_rms = 0;    ///< ...and the root-mean-square distance
    double triple_max = 0;  ///< largest difference between the arrivals of the fronts of a junction
    int triples = 0;        ///< junctions of three fronts or more
};

/// The errors at a time. O(triangles * discs) beside fronts.
[[nodiscard]] Distance distance_from_exact(const Complex<double>& complex, const Discs& discs,
                                           double time);

struct Case {
    int number = 3;
    std::uint64_t seed = 0;
    double h = 0.02;
    double step = 0.5;         ///< in edge lengths
    double contact = 0;        ///< in edge lengths; 0: the library's default
    std::uint32_t threads = 1; ///< 1: sequential
};

struct Result {
    Distance last;
    double time = 0; ///< at which the square was full
    bool is_full = false;
    bool is_valid = false;
    std::map<std::string, int> events;
    std::uint64_t unreached = 0;
    double min_angle_last = 0; ///< in degrees
    double min_angle_ever = 0; ///< after any step
    double seconds = 0;        ///< of the steps
    std::uint64_t mesh_hash = 0;
};

[[nodiscard]] Complex<double> first_complex(const Discs& discs, double h);
[[nodiscard]] Result run(const Case& one);

} // namespace dsc::fronts
