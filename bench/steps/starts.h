// SPDX-License-Identifier: MIT
// Scenes at the step from which they are measured, with the mesh from which all strategies start.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/complex.h"
#include "scenes/scene.h"

#include <memory>
#include <optional>
#include <string>

namespace dsc::bench {

/// Number of steps that are not timed: they visit the whole mesh for the first time and warm the
/// caches.
inline constexpr int warm_up_steps = 16;
/// Number of timed steps: the number between two choices of the cuts (SlabOptions::recut), so that
/// each measurement contains exactly one.
inline constexpr int timed_steps = 64;

/// The measured steps of a scene.
enum class Part : std::uint8_t {
    whole,       ///< all of them
    middle,      ///< `timed_steps` around the middle of the scene
    around,      ///< `timed_steps` around a given time
    before_half, ///< the last ones before a flow turns back
};

/// A scene at one size, and the steps to be measured.
struct Workload {
    scenes::Scene scene{};
    scenes::Parameters parameters{};   ///< with the size and all settings
    std::optional<double> dt_over_h{}; ///< the time step in edge lengths; empty: the scene's own
    Part part = Part::whole;
    double around = 0;                  ///< a time, of Part::around
    std::optional<double> area_error{}; ///< see Start::area_limit; empty: that of round shapes
};

/// A scene at the step from which all strategies start.
struct Start {
    scenes::Parameters parameters;
    scenes::Setup setup;
    int step = 0; ///< number of completed steps
    /// The largest relative error of the area, if the exact one is known.
    double area_limit = 0;
    Complex<double> complex; ///< empty until `make_ready`
};

/// The start of a workload, shared by all workloads with the same `key`. `where` is the place in
/// the suite, for errors. Throws InputError for single steps of a scene that does not move only by
/// a velocity, or that has too few steps.
[[nodiscard]] std::shared_ptr<Start> start_of(const Workload& workload, const std::string& key,
                                              const std::string& where);

/// Makes the complex on the first call, by a sequential run of the scene up to its step. Throws
/// InvariantError if a vertex does not arrive.
void make_ready(Start& start);

/// Makes one step of the scene.
StepReport advance(Simulation<double>& simulation, const scenes::Setup& setup, int step);

/// The memory of the complexes of all starts, in 10^6 bytes.
[[nodiscard]] double starts_mb();

} // namespace dsc::bench
