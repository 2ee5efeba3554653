// SPDX-License-Identifier: MIT
// The scene of a row, and its answer, from its parts: the place and the phases give the curves, the
// motion gives a map under which the exact shape at the end is that of the start, and the turn of
// the scene is applied to all of them.
#pragma once

#include "combinations/row.h"

#include "dsc/initial/initial_complex.h"

#include <functional>
#include <numbers>
#include <vector>

namespace dsc::combinations {

struct Scene {
    double length_unit = 1; ///< that lengths are given in
    double time_unit = 1;
    double h = 0.04;
    Rectangle domain;
    std::vector<Curve> curves;
    Phase phases = 2; ///< the exterior among them

    double end = 1; ///< the time
    int steps = 24;

    /// Where a place of the interface is at the end. Places on the domain boundary stay on it;
    /// where pieces of a phase overlap then, they are one.
    std::function<Point<double>(const Point<double>&)> exact;
    /// By place and time; none for `grow`, `shrink`, `curvature` and `vanish`.
    std::function<Point<double>(const Point<double>&, double)> velocity;
    /// The largest curvature of the curves at any time, where they are smooth; 0: they are
    /// straight.
    double curvature = 0;
    double longest_at_start = 1; ///< interface edge, in edge lengths
    double stretch = 1;          ///< the largest factor by which a piece of a curve becomes longer
    /// The shape meets itself or a side of the domain, or a piece of it vanishes: where the
    /// topology may change, that is told; where it is kept, vertices are in each other's way.
    bool meets = false;
    /// If it meets something: the length along which, and the angle between each sheet and that
    /// line at its two ends, at the end of the run. A side of the domain is the line itself.
    double seam = 0;
    double seam_angle = std::numbers::pi / 2;
    bool meets_boundary = false;
    /// Vertices have targets beyond a side of the domain, and need not arrive.
    bool runs_into_boundary = false;

    /// By how much the areas change that no map tells, by phase: those of curvature flow at
    /// junctions, by the rule of J. von Neumann (1952) and W. W. Mullins (1956). Empty: `exact`
    /// tells.
    std::vector<double> area_changes;
};

/// With edges of the usual length over `fineness`.
[[nodiscard]] Scene scene_of(const Row& row, double fineness);

/// The same scene with all lengths and times multiplied by these. Coordinates are only names of
/// places: by powers of two everything in it has the same bits, since lengths are never compared
/// with absolute numbers. The members that serve tolerances alone stay as they are.
[[nodiscard]] Scene in_units(Scene scene, double length, double time);

} // namespace dsc::combinations
