// SPDX-License-Identifier: MIT
// A closed polygon of markers in a flow, without a mesh: the lower bound for all methods that track
// an interface by its vertices. Comparison with a mesh shows the cost and the error of the mesh.
#pragma once

#include "reference/algorithm/interpolators.h"

#include "dsc/base/types.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace dsc::reference {

using Markers = std::vector<Point<double>>;

/// Writes the velocity at each position at one time.
using BatchVelocity = std::function<void(std::span<const Point<double>> positions, double time,
                                         std::span<Point<double>> velocities)>;

struct MarkerOptions {
    double longest = 1.0 / 64; ///< a marker is inserted if an edge is longer
    double shortest = 0;       ///< a marker is removed if an edge is shorter; 0: never
    InterfacePoint insertion = &lagrange_point; ///< position of new markers
};

struct MarkerCounts {
    std::size_t inserted = 0;
    std::size_t removed = 0;
};

/// Moves all markers by one step of the classical Runge-Kutta method. O(n).
void move_markers(Markers& markers, const BatchVelocity& velocity, double time, double dt);

/// Halves each edge that is too long, once; then removes the first marker of each edge that is too
/// short, but never two in a row, and at least eight markers remain. O(n). Throws InputError for
/// fewer than four markers, or unless 0 <= shortest < longest / 2.
MarkerCounts space_markers(Markers& markers, const MarkerOptions& options);

/// The curve through the markers: each edge replaced by `parts` chords of the 4-point Lagrange
/// cubic. O(n parts). Throws InputError for fewer than four markers or no parts.
[[nodiscard]] Markers read_as_cubic(std::span<const Point<double>> markers, int parts);

} // namespace dsc::reference
