// SPDX-License-Identifier: MIT
// A suite: the measurements of dsc_bench, read from a TOML file. bench/suites has those of the
// project.
//
//     also = ["operation", "kernel", "flow", "space"]  # rows that need no scene; see suites.h
//
//     [[case]]
//     scene = "swirl"             # of `dsc_scene list`, or a scene file, relative to this file; or
//                                 # a list of scenes
//     name = "mine"               # rows are called NAME_MEASURE/...; a list: one for each scene;
//                                 # default: the scene's name
//     measure = "run"             # or "step", "model", "option", "result": see Measure
//     h = [0.01, 0.005]           # sizes: edge lengths; or triangles = [28000], approximate
//                                 # numbers in the unit square; default: the scene's own h
//     set = { insertion = "linear" }        # keys of `dsc_scene run --set`
//     strategies = ["sequential", "cells"]  # the default; model: cells; result: sequential
//     threads = [1, 2]            # of the parallel ones; default "cores": 1, 2, 4, ... and all
//                                 # cores of the machine; result: 1
//     submeshes = 8               # or "threads" or "cores": one for each; default: the strategy's
//                                 # number, in a step at least one for each thread
//     dt_over_h = 0.3             # the time step in edge lengths
//     area_error = 0.01           # results with a larger relative error of the area are not timed
//                                 # (default 0.01); "round": the error of chords of round shapes.
//                                 # Not checked if the exact area is unknown
//     between_us = [0, 100]       # run: other work of the application between two steps
//     at = 0.15                   # step, model: the time around which steps are timed, or "half":
//                                 # before the flow turns back; default: the middle
//     option = { topology = "change" }      # option: compared with the scene without it
//     same_mesh = true            # option: it must not change the mesh
//     seeds = [1, 2, 3]           # result: one run for each value of `seed`
//     vertex_error = 0.1          # in three dimensions, instead of area_error: a larger root mean
//                                 # square, in edge lengths, of the distances from the exact shape
//     stop_after = 4              # in three dimensions: only the first steps, where a whole run
//                                 # would take hours; vertex_error is then not checked; default:
//                                 # all
//
// Scenes in three dimensions have measure = "run" or "model", and the keys name, h,
// set, strategies, threads, submeshes, vertex_error and stop_after.
//
//     rows = [{ measure = "step" }]         # each is a separate case with its keys and those above
//
// The same file may have keys of dsc_verify, such as `limits` (verify/gate/suite.h). A single value
// is a list of one.
#pragma once

#include "scenes/run/run.h"
#include "scenes/space/scene.h"
#include "steps/starts.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace dsc::bench {

enum class Measure : std::uint8_t {
    run,    ///< whole runs, as in an application
    step,   ///< a step in the middle of a scene, with warm threads
    model,  ///< the same, modelled for any number of threads from the times of tasks
    option, ///< the cost of an option in a step
    result, ///< whole runs that are not timed, made by bench/Snakefile with dsc_scene
};

/// One row of the result. Measure::option has a `Comparison` instead, Measure::result nothing.
struct Row {
    std::string name{};
    Measure measure = Measure::run;
    std::shared_ptr<Start> start{};
    scenes::Strategy strategy = scenes::Strategy::sequential;
    std::uint32_t submeshes = 0; ///< 0: chosen during the run
    std::uint32_t threads = 1;
    int between_us = 0;

    /// The options of its runs on this number of threads.
    [[nodiscard]] scenes::RunOptions options(std::uint32_t on_threads) const;
};

/// A scene with and without an option.
struct Comparison {
    std::string name;
    scenes::Scene scene;
    scenes::Parameters without;
    scenes::Parameters with;
    bool same_mesh = false; ///< whether the option must not change the result
};

/// A row of whole runs in three dimensions, or of their first steps.
struct SpaceRow {
    std::string name;
    std::shared_ptr<const scenes::space::Scene> scene;
    scenes::Parameters parameters; ///< with the size and all settings
    double vertex_error = 0.1;     ///< the largest that is timed
    scenes::Strategy strategy = scenes::Strategy::sequential;
    std::uint32_t submeshes = 0; ///< 0: by the extent of the interface
    std::uint32_t threads = 1;
    int stop_after = 0; ///< steps; 0: a whole run
    bool is_modelled = false;
};

struct Suite {
    std::vector<Row> rows;
    std::vector<SpaceRow> space_rows;
    std::vector<Comparison> comparisons;
    std::vector<std::string> also; ///< of `also_names`
    bool has_results = false;      ///< whether there is a case of Measure::result
};

/// The names that `also` may have.
[[nodiscard]] const std::vector<std::string>& also_names();

/// Reads a suite, and prepares its scenes without making their meshes. Throws InputError with file,
/// line, key, value and what is allowed; also for files that cannot be read, and for two rows with
/// the same name.
[[nodiscard]] Suite read_suite(const std::filesystem::path& path);

} // namespace dsc::bench
