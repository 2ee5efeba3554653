// SPDX-License-Identifier: MIT
// The complexes that step benchmarks start from: a scene of the thesis, section 9.7 that is well
// under way.
#pragma once

#include "dsc/complex/complex.h"
#include "scenes/scene.h"

#include <cstdint>
#include <string>

namespace dsc::bench {

/// Steps that are not timed: they examine the whole mesh for the first time and warm the caches.
inline constexpr int warm_up_steps = 16;
/// Steps that are timed: as many as lie between two choices of the cuts (SlabOptions::recut), so
/// that each measurement contains exactly one.
inline constexpr int timed_steps = 64;

/// A scene at the time from which all strategies start.
struct Start {
    std::string family; ///< of the benchmark
    scenes::Parameters parameters;
    scenes::Setup setup;
    int step = 0; ///< done so far
    Complex<double> complex;
};

/// `scaling_step` or `four_circles_step` with about so many triangles in the unit square: h such
/// that as many equilateral triangles fill it, 0.3 h of way a step, grown sequentially until the
/// middle of the timed steps lies 0.15 from the beginning (a circle of radius 0.25; 28,000
/// triangles and about 170 interface vertices as in the thesis). `swirl_step`: the swirl of 2 x 260
/// steps, up to where it turns back and the interface is longest. Made once, then kept.
[[nodiscard]] const Start& start_of(const std::string& family, int triangles);

/// Memory that all of them hold, in 10^6 bytes.
[[nodiscard]] double starts_mb();

} // namespace dsc::bench
