// SPDX-License-Identifier: MIT
// The complexes that step benchmarks start from: a scene of thesis 9.7 that is well under way.
#pragma once

#include "dsc/complex/complex.h"
#include "scenes/scene.h"

#include <cstdint>
#include <string>

namespace dsc::bench {

/// Steps before the clock runs: they pay for the first look at the whole mesh and warm the caches.
inline constexpr int warm_up_steps = 16;
/// Steps that are timed: as many as lie between two choices of the cuts (SlabOptions::recut), so
/// that slabs by counting pay for exactly one of them.
inline constexpr int timed_steps = 64;

/// A scene at a time from which all strategies go on.
struct Start {
    std::string family; ///< of the benchmark
    scenes::Parameters parameters;
    scenes::Setup setup;
    int step = 0; ///< done so far
    Complex<double> complex;
};

/// `scaling_step` or `four_circles_step` with about so many triangles in the unit square: h such
/// that as many equilateral triangles fill it, 0.3 h of way a step, grown sequentially until the
/// middle of the timed steps lies 0.15 from the begin (a circle of radius 0.25; 28,000 triangles
/// and about 170 interface vertices as in the thesis). `swirl_step`: the swirl of 2 x 260 steps, up
/// to where it turns back, where the interface is dense. Made once, then kept.
[[nodiscard]] const Start& start_of(const std::string& family, int triangles);

/// Memory that all of them hold, in 10^6 bytes.
[[nodiscard]] double starts_mb();

} // namespace dsc::bench
