// SPDX-License-Identifier: MIT
// The scene of a row, and its answer, from its parts: the place and the phases give the curves, the
// motion gives a map under which the exact shape at the end is that of the start, and the turn of
// the scene is applied to all of them.
#pragma once

#include "combinations/row.h"

#include "dsc/initial/initial_complex.h"

#include <functional>
#include <vector>

namespace dsc::combinations {

struct Scene {
    double h = 0.04;
    Rectangle domain;
    std::vector<Curve> curves;
    Phase phases = 2;     ///< the exterior among them
    Point<double> middle; ///< of the box about the interface, at the start

    double end = 1; ///< the time
    int steps = 24;

    /// Where a place of the interface is at the end. Places on a wall stay on it; where pieces of
    /// a phase overlap then, they are one.
    std::function<Point<double>(const Point<double>&)> exact;
    /// Where Euler's method brings it in so many equal sub-steps, if it is far from there: turns
    /// become spirals.
    std::function<Point<double>(const Point<double>&, std::uint32_t sub_steps)> by_euler;
    /// Velocity by place and time; for `grow`, `shrink` and `curvature` nothing.
    std::function<Point<double>(const Point<double>&, double)> velocity;
    double fastest = 0; ///< of these velocities
    /// The shape meets itself or a wall, or a piece of it vanishes: where the topology may change,
    /// that is told; where it is kept, vertices are in each other's way.
    bool meets = false;
    /// Vertices have targets beyond a wall, and need not arrive.
    bool runs_into_wall = false;

    /// By how much the areas change that no map tells, by phase: those of curvature flow at
    /// junctions, by the rule of J. von Neumann (1952) and W. W. Mullins (1956). Empty: `exact`
    /// tells.
    std::vector<double> area_changes;
    /// Only the area of all phases together is known.
    bool is_only_conserved = false;
};

/// With edges of the usual length over `fineness`.
[[nodiscard]] Scene scene_of(const Row& row, double fineness);

} // namespace dsc::combinations
