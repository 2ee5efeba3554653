// SPDX-License-Identifier: MIT
// How far a shape may be off, by reasons: nothing but rounding where straight curves are carried
// along, and elsewhere what chords, cut corners, films and methods of a known order account for.
#pragma once

#include "combinations/scene.h"

#include <span>

namespace dsc::combinations {

/// In edge lengths.
struct Tolerance {
    double mean = 0;     ///< symmetric difference over the length of the curve
    double farthest = 0; ///< of an interface vertex from the curve

    Tolerance& operator+=(const Tolerance& other) {
        mean += other.mean;
        farthest += other.farthest;
        return *this;
    }
};

/// `length`: of the curve, in edge lengths.
[[nodiscard]] Tolerance tolerance_of(const Row& row, const Scene& scene, double length,
                                     std::size_t sub_steps);

/// Where the integrator of a row brings a place in sub-steps that begin at these times.
[[nodiscard]] Point<double> by_method(const Row& row, const Scene& scene,
                                      std::span<const double> times, const Point<double>& start);

} // namespace dsc::combinations
