// SPDX-License-Identifier: MIT
// Scenes at the step from which they are measured, and the mesh that all strategies start from.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/complex.h"
#include "scenes/scene.h"

#include <memory>
#include <optional>
#include <string>

namespace dsc::bench {

/// Steps that are not timed: they examine the whole mesh for the first time and warm the caches.
inline constexpr int warm_up_steps = 16;
/// Steps that are timed: as many as lie between two choices of the cuts (SlabOptions::recut), so
/// that each measurement contains exactly one.
inline constexpr int timed_steps = 64;

/// Which steps of a scene are measured.
enum class Part : std::uint8_t {
    whole,       ///< all of them
    middle,      ///< `timed_steps` around the middle of the scene
    around,      ///< as many around a time
    before_half, ///< the last ones before a reversing flow turns back
};

/// A scene at one size, and what is measured of it.
struct Workload {
    scenes::Scene scene{};
    scenes::Parameters parameters{};   ///< with the size and all settings
    std::optional<double> dt_over_h{}; ///< the time step in edge lengths; none: the scene's own
    Part part = Part::whole;
    double around = 0;                  ///< a time, of Part::around
    std::optional<double> area_error{}; ///< see Start::area_limit; none: that of round shapes
};

/// A scene at the step from which all strategies start.
struct Start {
    scenes::Parameters parameters;
    scenes::Setup setup;
    int step = 0; ///< done so far
    /// How far the area may be from the exact one, relative, where that is known.
    double area_limit = 0;
    Complex<double> complex; ///< empty until `make_ready`
};

/// The start of a workload; one for all workloads with the same `key`. `where` is that of the
/// suite, for errors. Throws InputError for steps of a scene that moves by more than a velocity,
/// or has fewer than are measured.
[[nodiscard]] std::shared_ptr<Start> start_of(const Workload& workload, const std::string& key,
                                              const std::string& where);

/// Makes the complex on the first call: up to its step, the scene is run sequentially. Throws
/// InvariantError where a vertex does not arrive on the way.
void make_ready(Start& start);

/// One step of the scene.
StepReport advance(Simulation<double>& simulation, const scenes::Setup& setup, int step);

/// Memory that the complexes of all starts hold, in 10^6 bytes.
[[nodiscard]] double starts_mb();

} // namespace dsc::bench
