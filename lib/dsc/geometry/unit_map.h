// SPDX-License-Identifier: MIT
// Maps coordinates of any size, also far from the origin, to numbers near one. The passes of the
// algorithm multiply up to six lengths; doubles would run out of exponents from about 1e-50 and
// 1e50 on, and out of digits far from the origin. Scenes beyond these limits run in unit
// coordinates:
//
//     world = origin + 2^exponent * unit
//
// The complex holds unit coordinates, so that no hot loop has to know about the map.
// initial/unit_box.h and motion/unit_velocity.h convert scenes and velocities.
#pragma once

#include "dsc/base/error.h"
#include "dsc/base/types.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace dsc {

/// The map between world and unit coordinates.
struct UnitMap {
    Point<double> origin{0.0, 0.0}; ///< in world coordinates
    int exponent = 0;               ///< one unit is 2^exponent in the world; -1000 to 1000
};

/// Converts a length, or a component of a vector. Exact unless it underflows, because only the
/// exponent changes.
inline double length_to_unit(const UnitMap& map, double length) {
    return length * std::ldexp(1.0, -map.exponent);
}
/// The inverse of `length_to_unit`.
inline double length_to_world(const UnitMap& map, double length) {
    return length * std::ldexp(1.0, map.exponent);
}

/// A point of the world in unit coordinates.
inline Point<double> to_unit(const UnitMap& map, const Point<double>& world) {
    return (world - map.origin) * std::ldexp(1.0, -map.exponent);
}
/// The inverse of `to_unit`. Rounds if the origin is not zero.
inline Point<double> to_world(const UnitMap& map, const Point<double>& unit) {
    return map.origin + unit * std::ldexp(1.0, map.exponent);
}

/// The map under which the larger side of the box from `low` to `high` has a length from 1 to 2. An
/// axis on which the box lies at least its own size away from zero is shifted by its end next to
/// zero; the difference of two such coordinates is exact (P. H. Sterbenz, "Floating-point
/// computation", 1974), and so are `to_unit` of a point of the box and the way back. Throws
/// InputError where a coordinate is not finite, the box is empty, or its size lies beyond 1e-290 to
/// 1e290.
inline UnitMap fit_unit_map(const Point<double>& low, const Point<double>& high) {
    const Point<double> sides = high - low;
    const double size = sides.maxCoeff();
    constexpr double least = 1e-290;
    if (!low.allFinite() || !(sides.minCoeff() > 0) || !(size >= least && size <= 1 / least)) {
        std::array<char, 32> text{};
        const auto end = std::to_chars(text.data(), text.data() + text.size(), size);
        throw InputError(
            {.what = "not a box that can be mapped",
             .where = "fit_unit_map",
             .value = "a larger side of " + std::string(text.data(), end.ptr),
             .allowed = "low below high, finite, and a larger side of 1e-290 to 1e290"});
    }
    UnitMap map;
    map.exponent = std::ilogb(size);
    for (int axis = 0; axis < 2; ++axis) {
        if (low[axis] >= size) {
            map.origin[axis] = low[axis];
        } else if (high[axis] <= -size) {
            map.origin[axis] = high[axis];
        }
    }
    return map;
}

} // namespace dsc
