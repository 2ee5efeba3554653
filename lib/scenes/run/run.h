// SPDX-License-Identifier: MIT
// Runs a scene and measures it. The time of measuring is not counted, except that of the log of
// edits, a few per cent of a step.
#pragma once

#include "measures/histogram.h"
#include "measures/junctions.h"
#include "measures/measures.h"
#include "measures/phases.h"
#include "scenes/output/frames.h"
#include "scenes/output/series.h"
#include "scenes/run/checkpoint.h"
#include "scenes/run/strategy.h"
#include "scenes/scene.h"
#include "topology/events.h"

#include <atomic>
#include <functional>
#include <limits>
#include <map>
#include <optional>

namespace dsc::scenes {

struct RunOptions {
    Strategy strategy = Strategy::sequential;
    Submeshing submeshing; ///< of the parallel strategies
    FramePlan frames;      ///< .vtu and .pvd
    std::string edits;     ///< file for the log of edits (replay/replay.h); empty: none
    int series_every = 0;  ///< steps between rows of the time series; 0: none
    bool progress = false; ///< a line on stderr
    /// The measures at the end, and half-way if the flow turns back.
    std::vector<Measure> measures = default_measures();
    /// false: figures that need the exact shape are NaN. If the shape has no closed form, computing
    /// it takes longer than a run on a coarse mesh.
    bool measure_shape = true;
    const std::atomic<bool>* interrupted = nullptr; ///< ends the run after the current step
    int stop_after = 0; ///< ends the run after this step as an interruption does; 0: not
    CheckpointPlan checkpoint;
    /// The checkpoint to resume from; null: start from the beginning. The scene, its parameters and
    /// the strategy must be those of the run that wrote it.
    const Checkpoint* resume = nullptr;
    /// Called after each step (0: before the first) with the double complex; for tests. Not called
    /// by float runs or by the reference.
    std::function<void(int step, const Complex<double>& complex)> observer;
};

struct RunResult {
    std::string scene;
    Parameters parameters;
    Strategy strategy = Strategy::sequential;
    std::uint32_t submeshes = 1;
    std::uint32_t threads = 1;      ///< largest number allowed
    std::uint32_t threads_used = 1; ///< largest number used in a step
    int steps = 0;                  ///< completed; fewer than planned if `interrupted` or `gave_up`
    bool interrupted = false;
    std::string gave_up; ///< empty, or the reason
    /// Whether steps are missing: the figures are then those of the last completed step.
    [[nodiscard]] bool is_partial() const { return interrupted || !gave_up.empty(); }

    InputReport input; ///< simplification of the scene's shapes or curves
    std::uint64_t triangles_first = 0;
    std::uint64_t triangles_last = 0;
    std::uint64_t interface_vertices_last = 0;
    double area_first = 0; ///< of the first polygon
    double area_exact_first = 0;
    double area_ratio = 0;       ///< A(t_n) / A(t_0), as in the thesis
    Figures last;                ///< values of the measures, at the end
    std::optional<Figures> half; ///< half-way, if the flow turns back
    /// Largest error of the value that the scene keeps at vertices, at the end; NaN without one.
    double attribute_error = std::numeric_limits<double>::quiet_NaN();
    Figures fluid;      ///< figures of a fluid (fluid_run.h); empty without one
    Figures diagram;    ///< errors of growing discs against the exact diagram; empty without them
    PhaseReport phases; ///< at the end, like the next member
    JunctionFigures junctions;
    double min_quality_ever = 0;
    int quality_sampled_every = 1; ///< steps between samples of `min_quality_ever` and `inverted`
    std::uint64_t inverted = 0;    ///< triangles that an exact predicate found not positive, summed
    std::uint64_t unreached = 0;
    std::uint64_t held = 0; ///< of the unreached ones, because of a velocity that was not finite
    std::uint64_t sub_steps = 0;
    std::map<std::string, std::uint64_t> operations;
    std::vector<Event> events;     ///< changes of topology
    AreaAccount area;              ///< area given back, if the options ask for it
    std::vector<SeriesRow> series; ///< includes the first and the last step; empty if not requested
    double cpu_s = 0;              ///< of all steps, without measuring
    double wall_s = 0;
    double first_step_us = 0; ///< wall time, as the next
    double step_us_median = 0;
    std::uint64_t mesh_hash = 0;
    double peak_memory_mb = 0;   ///< of the process, so far
    Histogram area_histogram;    ///< over 0 to 3 areas of an equilateral triangle of edge h
    Histogram quality_histogram; ///< over 0 to 1
    Histogram angle_histogram;   ///< over 0 to 60 degrees

    static constexpr std::size_t area_bins = 60;
    static constexpr std::size_t quality_bins = 50;
    static constexpr std::size_t angle_bins = 60;

    /// Whether no triangle was inverted, all vertices arrived, and no step gave up.
    [[nodiscard]] bool holds() const { return inverted == 0 && unreached == 0 && gave_up.empty(); }
};

/// Writes or reads the sums and figures so far, without those measured at the end.
void archive(Archive& archive, SeriesRow& row);
void archive(Archive& archive, RunResult& result);

/// Throws InputError for options that the strategy does not support.
void check_usage(const Scene& scene, const Setup& setup, const Parameters& parameters,
                 const RunOptions& options);

/// Throws InputError before the first step; FileError if a frame or a checkpoint cannot be written,
/// or if `resume` is damaged or was written by another run. Results of an interrupted and resumed
/// run are bitwise identical to those of an uninterrupted one, except for times.
RunResult run_scene(const Scene& scene, const Parameters& parameters, const RunOptions& options);

} // namespace dsc::scenes
