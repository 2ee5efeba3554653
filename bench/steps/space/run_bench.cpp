// SPDX-License-Identifier: MIT
// Whole runs of any scene in three dimensions, and the model of more threads. The counter
// `us_per_step` is the mean time of all steps, without the measuring between them.
#include "steps/context.h"
#include "steps/model_counters.h"
#include "steps/refusal.h"
#include "steps/space/model.h"
#include "steps/suites.h"

#include "dsc/base/error.h"
#include "scenes/keys.h"
#include "scenes/space/run.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

namespace dsc::bench {

namespace {

using scenes::Strategy;
using scenes::space::RunResult;

struct SpaceRun {
    RunResult result;
    SpaceProfile profile;
};

SpaceRun run_row(const SpaceRow& row, std::uint32_t threads) {
    SpaceRun run;
    scenes::space::RunOptions options;
    options.parallel = scenes::space::parallel_of(
        row.strategy, {.threads = threads, .submeshes = row.submeshes, .profile = true});
    options.stop_after = row.stop_after;
    options.after_step = [&](const dsc3::Simulation& simulation, double wall) {
        run.profile.add(simulation.profile(), wall);
    };
    run.result = scenes::space::run_scene(*row.scene, row.parameters, options);
    return run;
}

// The root mean square, in edge lengths, of the distances of vertices from the exact shape.
std::optional<double> vertex_error(const RunResult& result) {
    return result.vertex_error_rms ? std::optional(*result.vertex_error_rms / result.parameters.h)
                                   : std::nullopt;
}

void check(const RunResult& result, const SpaceRow& row) {
    if (!result.holds()) {
        throw InvariantError(result.problem.empty()
                                 ? std::to_string(result.sum.unreached) +
                                       " vertices did not arrive, or a tet was inverted"
                                 : result.problem);
    }
    if (const auto error = vertex_error(result); error && !(*error <= row.vertex_error)) {
        throw InvariantError("vertices are off the exact shape by " + to_text(*error) +
                             " edge lengths (rms), where " + to_text(row.vertex_error) +
                             " are allowed");
    }
}

// A text of all on which the mesh depends.
std::string key_of(const SpaceRow& row) {
    return row.scene->name + scenes::text_of(row.parameters) + '/' +
           scenes::to_string(row.strategy) + '/' + std::to_string(row.submeshes) + '/' +
           std::to_string(row.stop_after);
}

// The hash of the mesh of a run with one thread, which all runs of a parallel strategy must have;
// the first call makes this run.
std::uint64_t expected_hash(const SpaceRow& row) {
    static std::map<std::string, std::uint64_t> known;
    const std::string key = key_of(row);
    const auto found = known.find(key);
    if (found != known.end()) {
        return found->second;
    }
    const RunResult result = run_row(row, 1).result;
    check(result, row);
    return known.emplace(key, result.mesh_hash).first->second;
}

SpaceRun checked_run(const SpaceRow& row, std::uint32_t threads) {
    SpaceRun run = run_row(row, threads);
    check(run.result, row);
    if (row.strategy != Strategy::sequential && run.result.mesh_hash != expected_hash(row)) {
        throw InvariantError("the mesh is not that of a run with one thread");
    }
    return run;
}

void measure(benchmark::State& state, const SpaceRow& row) {
    if (row.strategy != Strategy::sequential) {
        (void)expected_hash(row);
    }
    for (auto _ : state) {
        const double load = other_load();
        const SpaceRun run = checked_run(row, row.threads);
        const RunResult& result = run.result;
        state.SetIterationTime(result.wall_s);
        auto& counters = state.counters;
        counters["us_per_step"] = 1e6 * result.wall_s / result.steps;
        counters["cpu_us_per_step"] = 1e6 * result.cpu_s / result.steps;
        counters["first_step_us"] = result.first_step_us;
        counters["interface_vertices"] = result.interface_vertices_max;
        counters["tets"] = result.tets_last;
        counters["min_dihedral_deg"] = result.quality_ever.min_dihedral;
        counters["load"] = load;
        counters["threads_used"] = row.threads;
        counters["oversubscribed"] = row.threads > core_count() ? 1 : 0;
        if (const auto error = vertex_error(result)) {
            counters["vertex_error_h"] = *error;
        }
        const double serial_s = run.profile.serial();
        const double busy_s = serial_s + run.profile.tasks();
        counters["utilisation"] = busy_s / (row.threads * result.wall_s);
        counters["serial_share"] = serial_s / busy_s; // of the work
    }
}

void measure_model(benchmark::State& state, const SpaceRow& row) {
    // The profile of a run serves several numbers of threads.
    static std::map<std::string, SpaceProfile> profiles;
    const std::uint32_t at_work = row.threads > 1 ? core_count() : 1;
    for (auto _ : state) {
        const double load = other_load();
        static const double fork_join = measure_fork_join(core_count());
        const std::string key = key_of(row) + '/' + std::to_string(at_work);
        auto found = profiles.find(key);
        if (found == profiles.end()) {
            found = profiles.emplace(key, checked_run(row, at_work).profile).first;
        }
        const SpaceProfile& run = found->second;
        const double start = std::max(fork_join, measured_start(run, at_work));
        const ModelTimes times = model(run, row.threads, start);
        count_model(state, times, start, fork_join, run.steps);
        state.counters["load"] = load;
    }
}

} // namespace

void register_space_run(const SpaceRow& row) {
    add_long_row(row.name, [row](benchmark::State& state) {
        row.is_modelled ? measure_model(state, row) : measure(state, row);
    });
}

} // namespace dsc::bench
