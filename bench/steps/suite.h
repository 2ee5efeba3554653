// SPDX-License-Identifier: MIT
// A suite: what dsc_bench measures, read from a TOML file. bench/suites has ours.
//
//     also = ["operation", "kernel", "flow"]  # rows that need no scene; see suites.h
//
//     [[case]]
//     scene = "swirl"             # of `dsc_scene list`, or a scene file, whose path begins at this
//                                 # file; or a list of scenes
//     name = "mine"               # rows are called NAME_MEASURE/...; a list: one for each scene;
//                                 # unless given, the scene's own
//     measure = "run"             # or "step", "model", "option", "result": see Measure
//     h = [0.01, 0.005]           # sizes: edge lengths; or triangles = [28000], about so many in
//                                 # the unit square; or neither: the scene's own h
//     set = { insertion = "linear" }        # keys of `dsc_scene run --set`
//     strategies = ["sequential", "cells"]  # these unless given; model: cells; result: sequential
//     threads = [1, 2]            # of the parallel ones; or "cores": 1, 2, 4, ... and all cores of
//                                 # the machine, which holds unless given; result: 1
//     submeshes = 8               # or "threads" or "cores": as many as there are; else the
//                                 # strategy's own number, in a step at least one for each thread
//     dt_over_h = 0.3             # the time step in edge lengths
//     area_error = 0.01           # no result is timed whose area is further off, relative (0.01
//                                 # unless given); "round": what the chords of round shapes leave
//                                 # out. Not checked where no area is known
//     between_us = [0, 100]       # run: other work of the application between two steps
//     at = 0.15                   # step, model: the time around which steps are timed, or "half":
//                                 # those before a flow turns back; unless given, the middle
//     option = { topology = "change" }      # option: compared with the scene without it
//     same_mesh = true            # option: it must not change the mesh
//     seeds = [1, 2, 3]           # result: a run for each, with this `seed`
//     rows = [{ measure = "step" }]         # each is a case of its own: its keys and those above
//
// What dsc_verify alone reads, such as `limits`, may stand in the same file (verify/gate/suite.h).
// Single values may stand for lists of one.
#pragma once

#include "scenes/run/run.h"
#include "starts.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace dsc::bench {

enum class Measure : std::uint8_t {
    run,    ///< whole runs, as an application makes them
    step,   ///< a step of a scene that is under way, with warm threads
    model,  ///< the same, modelled for any number of threads from the times of tasks
    option, ///< what an option costs in a step
    result, ///< whole runs that nobody times, for bench/Snakefile alone: each by dsc_scene
};

/// One row of the result; Measure::option has `Comparison` instead, Measure::result none.
struct Row {
    std::string name{};
    Measure measure = Measure::run;
    std::shared_ptr<Start> start{};
    scenes::Strategy strategy = scenes::Strategy::sequential;
    std::uint32_t submeshes = 0; ///< 0: chosen during the run
    std::uint32_t threads = 1;
    int between_us = 0;

    /// What its runs are asked for, on so many threads.
    [[nodiscard]] scenes::RunOptions options(std::uint32_t on_threads) const;
};

/// A scene with and without an option.
struct Comparison {
    std::string name;
    scenes::Scene scene;
    scenes::Parameters without;
    scenes::Parameters with;
    bool same_mesh = false; ///< the option must not change the result
};

struct Suite {
    std::vector<Row> rows;
    std::vector<Comparison> comparisons;
    std::vector<std::string> also; ///< of `also_names`
    bool has_results = false;      ///< a case of Measure::result
};

/// What `also` may name.
[[nodiscard]] const std::vector<std::string>& also_names();

/// Reads a suite, and prepares its scenes without making their meshes. Throws InputError with file,
/// line, key, value and what is allowed; also for files that cannot be read, and for two rows of
/// one name.
[[nodiscard]] Suite read_suite(const std::filesystem::path& path);

} // namespace dsc::bench
