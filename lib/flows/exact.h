// SPDX-License-Identifier: MIT
// Exact shapes at given times, against which errors are measured. They are computed without a mesh,
// and each states an estimate of its own error.
#pragma once

#include "flows/flow_map.h"
#include "shapes/curve.h"
#include "shapes/outline.h"

#include <span>

namespace dsc::scenes {

/// The first outlines moved rigidly, vertex by vertex: the result is the true shape.
[[nodiscard]] ExactShape translated_shape(std::span<const Outline> first,
                                          const Point<double>& displacement);
[[nodiscard]] ExactShape rotated_shape(std::span<const Outline> first, const Point<double>& centre,
                                       double angle);

/// A circle as a polygon with exactly its area. Throws InputError for a radius that is not
/// positive.
[[nodiscard]] ExactShape exact_circle(const Point<double>& centre, double radius,
                                      int vertices = 1 << 15);

/// The density of markers on a curve, in units of the square root of its area.
struct MarkerOptions {
    double spacing = 7.5e-4; ///< largest distance between neighbours
    double deviation = 5e-8; ///< largest distance of the curve from a chord
};

/// Markers for a mesh whose interface edges have this length: `own_error` is about a thousandth of
/// the error of the edges' chords.
[[nodiscard]] MarkerOptions markers_for(const ParametricCurve& curve, double edge_length);

/// The image of a curve under an area-preserving map. Where markers are too far apart, or turn too
/// much, more points *of the curve* are mapped, so there is no error of insertion. Finally,
/// vertices are moved outwards by the mean distance of the curve from its chords, which makes the
/// polygon's area equal to that of the curve to fourth order. `rough` is the same map with half the
/// effort (or the same map if it is exact); its result, with markers twice as far apart, gives
/// own_error.
[[nodiscard]] ExactShape mapped_shape(const ParametricCurve& curve, const FlowMap& map,
                                      const FlowMap& rough, const MarkerOptions& options = {});

/// The image of a curve under a divergence-free flow at a time. The number of steps is chosen such
/// that for some points of the curve half as many steps give the same positions to 5e-7, in units
/// of the square root of its area. own_error is below 1e-7 for the swirl of a circle of radius 0.15
/// until time 4.2, and for the single vortex at half of a period of up to 8. For velocities with
/// kinks the number of steps is limited, and own_error states the accuracy reached.
[[nodiscard]] ExactShape advected_shape(const ParametricCurve& curve, const Flow& flow, double time,
                                        const MarkerOptions& options = {});

/// The curve itself: the shape after a flow and its reversal. Markers that need no flow are cheap,
/// so there are many: own_error is below 1e-9 for a circle of radius 0.15.
[[nodiscard]] ExactShape unmoved_shape(const ParametricCurve& curve,
                                       const MarkerOptions& options = {.deviation = 2e-9});

} // namespace dsc::scenes
