// SPDX-License-Identifier: MIT
// The units in which a scene is run whose coordinates are very large, very small, or far from the
// origin: the passes of the algorithm multiply up to six lengths, so that doubles would run out of
// exponents from about 1e-50 and 1e50 on, and out of digits far away. The application gives the
// library coordinates of a frame, and lengths and velocities divided by its unit:
//
//     world = origin + unit * coordinate
#pragma once

#include "dsc/base/require.h"

#include <cmath>

namespace dsc {

/// Where coordinates begin, and how long 1 is.
struct Frame {
    Point<double> origin{0.0, 0.0}; ///< in world coordinates
    double unit = 1;                ///< in world coordinates; a power of two: dividing is exact
};

/// The frame in which the larger side of the box from `low` to `high` is 1 to 2 long. An axis on
/// which the box lies at least its own size away from zero is shifted by its end next to zero; the
/// difference of two such coordinates is exact (P. H. Sterbenz, "Floating-point computation",
/// 1974). Throws InputError where a coordinate is not finite, the box is empty, or its size lies
/// beyond 1e-290 to 1e290.
inline Frame choose_frame(const Point<double>& low, const Point<double>& high) {
    const Point<double> sides = high - low;
    const double size = sides.maxCoeff();
    constexpr double least = 1e-290;
    if (!low.allFinite() || !(sides.minCoeff() > 0) || !(size >= least && size <= 1 / least)) {
        throw InputError(
            {.what = "not a box that has a frame",
             .where = "choose_frame",
             .value = "a larger side of " + to_text(size),
             .allowed = "low below high, finite, and a larger side of 1e-290 to 1e290"});
    }
    Frame frame;
    frame.unit = std::ldexp(1.0, std::ilogb(size));
    for (int axis = 0; axis < 2; ++axis) {
        if (low[axis] >= size) {
            frame.origin[axis] = low[axis];
        } else if (high[axis] <= -size) {
            frame.origin[axis] = high[axis];
        }
    }
    return frame;
}

} // namespace dsc
