// SPDX-License-Identifier: MIT
// Exact solutions for interfaces that move by their curvature and meet in junctions. Tension and
// mobility of all interfaces are 1, so the speed of an interface is its curvature; if their product
// is m, replace the time t by m t.
#pragma once

#include "dsc/initial/initial_complex.h"
#include "shapes/outline.h"

namespace dsc::scenes {

/// A grain of given area on the straight interface between two others, in equilibrium: two arcs of
/// one radius that meet at both tips under 120 degrees, each at 60 degrees to the interface, which
/// continues there.
struct Lens {
    Point<double> centre{0.5, 0.5};
    Point<double> axis{1, 0}; ///< direction of the interface, of any length
    double area = 0.1;
};

/// Its shape.
[[nodiscard]] ExactShape lens_shape(const Lens& lens);

/// Four phases that meet in one point at time 0, along straight interfaces at the angles theta,
/// pi - theta, pi + theta and -theta to the x axis. If the point splits so that the upper and the
/// lower phase no longer touch, an edge of length c sqrt(t) opens along the x axis, between two
/// junctions of 120 degrees, and the motion is self-similar: the curve that leaves the right
/// junction upwards is y = sqrt(t) u(x / sqrt(t)) with
///
///     2 u'' = (1 + u'^2) (u - xi u'),  u(c / 2) = 0,  u'(c / 2) = tan 60 degrees,
///
/// and its slope becomes tan theta far away. This is the change of neighbours (T1) of grains.
struct FourSectors {
    Point<double> centre{0.5, 0.5};
    double theta = 0.7853981633974483; ///< radians, above 0 and below pi / 3
};

/// The factor c, which is 0 at 60 degrees. By shooting, to about 1e-11; O(1e5) steps.
[[nodiscard]] double opening_factor(double theta);

/// The part of a box in the right one of the four phases, to about 1e-10; the curves are polygons
/// with the error `own_error`. If the box is so large that the curves are straight where they leave
/// it, the area falls at the rate 2 (pi / 3 - theta). The box is parallel to the axes, and the
/// curves leave it on its right side, or above and below. Throws InputError once the right junction
/// has left the box.
[[nodiscard]] ExactShape right_sector(const FourSectors& sectors, double time,
                                      const Rectangle& box);

} // namespace dsc::scenes
