// SPDX-License-Identifier: MIT
// The scene of a row, and its exact result: place and phases determine the curves, the motion
// determines a map from the first shape to the exact last one, and the rotation of the scene is
// applied to everything.
#pragma once

#include "combinations/row.h"

#include "dsc/initial/initial_complex.h"

#include <functional>
#include <numbers>
#include <vector>

namespace dsc::combinations {

struct Scene {
    double length_unit = 1; ///< unit of lengths
    double time_unit = 1;
    double h = 0.04;
    Rectangle domain;
    std::vector<Curve> curves;
    Phase phases = 2; ///< number of phases, including the exterior

    double end = 1; ///< the time
    int steps = 24;

    /// Maps a point of the first interface to its exact last position. Points on the domain
    /// boundary stay on it; pieces of a phase that overlap at the end are one piece.
    std::function<Point<double>(const Point<double>&)> exact;
    /// As a function of position and time; empty for `grow`, `shrink`, `curvature` and `vanish`.
    std::function<Point<double>(const Point<double>&, double)> velocity;
    /// The largest curvature of the curves at any time, where they are smooth; 0: they are
    /// straight.
    double curvature = 0;
    double longest_at_start = 1; ///< interface edge, in edge lengths
    double stretch = 1;          ///< the largest factor by which a piece of a curve becomes longer
    /// The shape meets itself or a side of the domain, or a piece of it vanishes: if the topology
    /// may change, there are events; if it is kept, vertices are blocked.
    bool meets = false;
    /// If the shape meets something: the length of the contact line at the end of the run, and the
    /// angle between each sheet and the line at its two ends. A side of the domain is the line
    /// itself.
    double seam = 0;
    double seam_angle = std::numbers::pi / 2;
    bool meets_boundary = false;
    /// Targets of some vertices lie beyond a side of the domain, so these vertices need not arrive.
    bool runs_into_boundary = false;

    /// The changes of areas by phase, where no map is known: by curvature flow with junctions, by
    /// the rule of J. von Neumann (1952) and W. W. Mullins (1956). Empty: use `exact`.
    std::vector<double> area_changes;
};

/// The scene with edges of the usual length divided by `fineness`.
[[nodiscard]] Scene scene_of(const Row& row, double fineness);

/// The same scene with all lengths and times multiplied by these factors. For powers of two the
/// result must be bitwise the scaled one, because lengths are never compared with absolute numbers.
/// Members used only for tolerances are not changed.
[[nodiscard]] Scene in_units(Scene scene, double length, double time);

} // namespace dsc::combinations
