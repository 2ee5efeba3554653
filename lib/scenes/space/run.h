// SPDX-License-Identifier: MIT
// Runs a scene in three dimensions and measures it. Measuring is not timed.
#pragma once

#include "dsc3/dsc3.h"
#include "scenes/output/frames.h"
#include "scenes/run/checkpoint.h"
#include "scenes/run/strategy.h"
#include "scenes/space/scene.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dsc::scenes::space {

/// The result of a run. Lengths and volumes are in units of the domain.
struct RunResult {
    std::string scene;
    Parameters parameters;
    std::vector<std::string> keys; ///< of the scene
    int steps = 0;                 ///< completed
    bool interrupted = false;
    std::uint32_t tets_first = 0;
    std::uint32_t tets_last = 0;
    std::uint32_t interface_vertices_last = 0;
    std::uint32_t interface_vertices_max = 0;
    double volume_first = 0;
    std::optional<std::int64_t> euler_first{};       ///< Euler number of the first interface
    std::optional<std::int64_t> euler_exact_first{}; ///< of the surface in the scene's file
    double volume_last = 0;
    double volume_exact_last = 0;
    std::optional<double>
        sd_rel_last{}; ///< volume between the interface and the exact one, relative
    std::optional<double> sd_rel_half{}; ///< the same when the flow turns back
    std::optional<double>
        vertex_error_rms{}; ///< distance of interface vertices from the exact shape
    std::optional<double> vertex_error_max{};
    dsc3::MeshQuality quality_last;
    dsc3::MeshQuality quality_ever;
    std::uint64_t inverted = 0;    ///< steps after which a tet was inverted
    std::string problem;           ///< the first problem that `validate` found at the end
    dsc3::StepReport sum;          ///< over all steps
    std::uint64_t tet_steps = 0;   ///< tets, summed over the steps
    std::vector<double> step_us{}; ///< of each step
    double cpu_s = 0;
    double wall_s = 0;
    double first_step_us = 0;
    double step_us_median = 0;
    std::uint64_t mesh_hash = 0;
    dsc3::StrataCounts strata_last;           ///< vertices of the interface
    std::optional<dsc3::Parallel> parallel{}; ///< none: sequential

    /// Whether no invariant was broken, and all vertices arrived.
    [[nodiscard]] bool holds() const {
        return problem.empty() && inverted == 0 && sum.unreached == 0 &&
               sum.gave_up == dsc3::GiveUp::none;
    }
};

/// The options and outputs of a run.
struct RunOptions {
    FramePlan frames{}; ///< frames of the tets (.vtu) and the interface (.ply)
    CheckpointPlan checkpoint{};
    const Checkpoint* resume = nullptr;       ///< to resume from, bitwise identically
    int stop_after = 0;                       ///< steps; 0: no such limit
    std::optional<dsc3::Parallel> parallel{}; ///< none: sequential
    /// Called after each step with its wall time in seconds.
    std::function<void(const dsc3::Simulation&, double)> after_step{};
    const std::atomic<bool>* interrupted = nullptr;
    bool progress = false; ///< whether to show a progress line
};

/// The options of a strategy; none for the sequential one. Throws InputError for a strategy that is
/// not available in three dimensions.
[[nodiscard]] std::optional<dsc3::Parallel> parallel_of(Strategy strategy,
                                                        const Submeshing& submeshing);

/// Runs all steps, or those until it is interrupted. Throws InputError for an integrator that is
/// not available, for shapes that `initial_complex` refuses, and for frames as `Frames` does;
/// FileError for a checkpoint of another run.
[[nodiscard]] RunResult run_scene(const Scene& scene, const Parameters& parameters,
                                  const RunOptions& options);

/// The name of the strategy.
[[nodiscard]] std::string strategy_of(const RunResult& result);

/// The figures that limits may name, and their values; NaN if not measured. Figures whose names end
/// in _h are in edge lengths.
[[nodiscard]] std::map<std::string, double> figures(const RunResult& result);

/// One JSON object.
[[nodiscard]] std::string to_json(const RunResult& result);

/// Prints the summary of a run.
void print_summary(const RunResult& result);

} // namespace dsc::scenes::space
