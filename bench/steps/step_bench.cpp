// SPDX-License-Identifier: MIT
// A time step (thesis, section 9.7), by every strategy from the same complex. An iteration is as
// many steps as `timed_steps`; the counter `us_per_step` is the time of one. S(n) is the ratio of
// the row `strategy:sequential` to the row with `threads:n`, of the same family and size.
#include "context.h"
#include "memory.h"
#include "refusal.h"
#include "step_run.h"
#include "suites.h"

#include "dsc/base/error.h"
#include "dsc/queries/hash.h"
#include "scenes/run/reference_run.h"
#include "scenes/run/start.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace dsc::bench {

namespace {

using scenes::Strategy;

constexpr int swirl_mesh = 95000;       ///< h a little below 0.005
constexpr int fine_swirl_mesh = 380000; ///< and a little below 0.0025
constexpr int small_mesh = 28000; ///< that of the thesis, and the only one for the literal method
constexpr std::uint32_t slabs = 8;
constexpr int reference_steps = 3;
constexpr double reference_area_limit = 0.01;

struct Case {
    std::string family;
    int triangles;
    Strategy strategy;
    std::uint32_t submeshes = 1;
    std::uint32_t threads = 1;
    bool modelled = false; ///< from the tasks' times, for any number of threads
};

scenes::RunOptions run_options(const Case& c, std::uint32_t threads) {
    scenes::RunOptions options;
    options.strategy = c.strategy;
    options.submeshing.submeshes = c.submeshes;
    options.submeshing.threads = threads;
    options.submeshing.always_all_threads = true;
    return options;
}

std::string name_of(const Case& c) {
    std::string name = c.family + "/strategy:" + scenes::to_string(c.strategy) +
                       "/triangles:" + std::to_string(c.triangles);
    if (c.strategy != Strategy::sequential && c.strategy != Strategy::reference) {
        name +=
            "/submeshes:" + std::to_string(c.submeshes) + "/threads:" + std::to_string(c.threads);
    }
    if (c.modelled) {
        name += "/modelled:1";
    }
    return name;
}

// A working copy with some room to grow, as a mesh under way has it.
Complex<double> copy_with_room(const Complex<double>& complex) {
    Complex<double> copy;
    const auto roomy = [](std::size_t n) { return n + n / 16 + 4096; };
    copy.reserve(roomy(complex.vertices.size()), roomy(complex.triangles.size()));
    copy = complex;
    return copy;
}

/// The result of a strategy, computed once on one thread, checked and kept: every measurement must
/// give the same bits.
const Answer& answer_of(const Case& c) {
    using Key = std::tuple<std::string, int, Strategy, std::uint32_t>;
    static std::map<Key, Answer> answers;
    const Key key{c.family, c.triangles, c.strategy, c.submeshes};
    if (const auto known = answers.find(key); known != answers.end()) {
        return known->second;
    }
    const Start& start = start_of(c.family, c.triangles);
    Complex<double> complex = copy_with_room(start.complex);
    const StepRun run = run_steps(start, complex, run_options(c, 1));
    const Answer answer = check_answer(start, complex, run,
                                       start.step + warm_up_steps + timed_steps, area_limit(start));
    return answers.emplace(key, answer).first->second;
}

/// Medians so far of the literal method, for the ratio: empty where it has not run.
std::map<std::string, std::vector<double>>& reference_times() {
    static std::map<std::string, std::vector<double>> times;
    return times;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void report(benchmark::State& state, const Case& c, const StepRun& run, const Answer& answer,
            double load) {
    const double us = run.wall_s * 1e6;
    auto& counters = state.counters;
    counters["us_per_step"] = us / run.steps;
    counters["cpu_us_per_step"] = run.cpu_s * 1e6 / run.steps;
    counters["us_per_vertex_step"] = us / run.vertex_steps;
    counters["interface_vertices"] = run.vertex_steps / run.steps;
    counters["triangles"] = static_cast<double>(answer.triangles);
    counters["min_quality"] = answer.min_quality;
    counters["area_error_rel"] = answer.area_error_rel;
    counters["load"] = load;
    counters["oversubscribed"] = c.threads > core_count() ? 1 : 0;
}

void measure(benchmark::State& state, const Case& c) {
    const Start& start = start_of(c.family, c.triangles);
    const Answer& expected = answer_of(c);
    for (auto _ : state) {
        Complex<double> complex = copy_with_room(start.complex);
        const double load = other_load();
        const PeakMemory memory;
        const StepRun run = run_steps(start, complex, run_options(c, c.threads));
        const double peak_mb = memory.mb() - starts_mb();
        if (run.unreached > 0 || run.gave_up || mesh_hash(complex) != expected.hash) {
            throw InvariantError("the mesh is not that of a run with one thread");
        }
        state.SetIterationTime(run.wall_s);
        report(state, c, run, expected, load);
        auto& counters = state.counters;
        counters["peak_memory_mb"] = peak_mb;
        counters["flips_per_step"] = static_cast<double>(run.operations.flips) / run.steps;
        counters["examined_per_step"] = static_cast<double>(run.operations.examined) / run.steps;
        const auto& reference = reference_times()[c.family];
        if (c.strategy == Strategy::sequential && c.triangles == small_mesh && !reference.empty()) {
            counters["speedup_vs_reference"] = median(reference) / (run.wall_s * 1e6 / run.steps);
        }
    }
}

/// The account of tasks of a strategy on so many threads: the least of all runs so far, at least
/// `account_runs`.
const ModelRun& account_of(const Case& c, std::uint32_t threads) {
    using Key = std::tuple<std::string, int, Strategy, std::uint32_t, std::uint32_t>;
    constexpr int account_runs = 3;
    static std::map<Key, ModelRun> accounts;
    ModelRun& account = accounts[{c.family, c.triangles, c.strategy, c.submeshes, threads}];
    const int runs = account.steps.empty() ? account_runs : 1;
    for (int i = 0; i < runs; ++i) {
        const Start& start = start_of(c.family, c.triangles);
        Complex<double> complex = copy_with_room(start.complex);
        take_least(account, profile_steps(start, complex, run_options(c, threads)));
        if (mesh_hash(complex) != answer_of(c).hash) {
            throw InvariantError("the mesh is not that of a run without an account of times");
        }
    }
    return account;
}

void measure_model(benchmark::State& state, const Case& c) {
    for (auto _ : state) {
        const double load = other_load();
        static const double fork_join = measure_fork_join(core_count());
        static const double bandwidth_of_one = measure_bandwidth(1);
        static const double bandwidth_of_all = measure_bandwidth(core_count());
        const std::uint32_t at_work = c.threads > 1 ? core_count() : 1;
        const ModelRun& account = account_of(c, at_work);
        const double start = std::max(fork_join, measured_start(account, at_work));
        const ModelTimes times = model(account, c.threads, start);
        state.SetIterationTime(times.seconds);
        const auto per_step = [](double seconds) { return seconds * 1e6 / timed_steps; };
        auto& counters = state.counters;
        counters["us_per_step"] = per_step(times.seconds);
        counters["modelled"] = 1;
        counters["serial_share"] = times.serial_share;
        counters["busy_share"] = times.busy_share;
        counters["fork_join_us"] = fork_join * 1e6; // without work
        counters["section_start_us"] = start * 1e6;
        counters["bandwidth_of_one_gb_s"] = bandwidth_of_one * 1e-9;
        counters["bandwidth_of_all_gb_s"] = bandwidth_of_all * 1e-9;
        // What one worker takes for all of it, by the least times.
        counters["us_serial"] = per_step(times.serial);
        counters["us_tasks"] = per_step(times.tasks);
        counters["us_starts"] = per_step(times.starts);
        counters["load"] = load;
        // Where the time of a step goes, summed over submeshes, in the fastest run.
        const SubStepProfile& total = account.total;
        counters["us_all_tasks"] = per_step(account.total_tasks);
        counters["us_set_up"] = per_step(total.set_up);
        counters["us_hand_over"] = per_step(total.hand_over);
        counters["us_clean_up"] = per_step(total.clean_up);
        counters["us_upkeep"] = per_step(total.upkeep);
        counters["us_velocities"] = per_step(total.velocities);
        counters["us_movement"] = per_step(total.motion_passes.at(0));
        counters["us_mesh_update"] = per_step(total.motion_passes.at(1));
        counters["us_later_colours"] = per_step(total.later_colours);
        double outside = 0;
        for (const double seconds : account.serial_outside) {
            outside += seconds;
        }
        counters["us_driver"] = per_step(outside);
    }
}

// The literal method needs no warm-up, as it sweeps the whole mesh in each step. It starts where
// the others have done half of their steps, so that its interface is as long as theirs on average.
void measure_reference(benchmark::State& state, const Case& c) {
    const Start& start = start_of(c.family, c.triangles);
    const int first = start.step + warm_up_steps + timed_steps / 2;
    static std::map<std::string, Complex<double>> half_way;
    auto& complex = half_way[c.family];
    if (complex.triangle_count() == 0) {
        complex = start.complex;
        const Options<double> options = scenes::scene_options<double>(start.parameters);
        Simulation<double> simulation(complex, options);
        for (int step = start.step; step < first; ++step) {
            simulation.step(start.setup.flow.front().velocity, step * start.parameters.dt,
                            start.parameters.dt);
        }
    }
    for (auto _ : state) {
        reference::Complex literal = scenes::to_reference(complex);
        const double load = other_load();
        const StepRun run = run_reference(start, literal, first, reference_steps);
        const Answer answer = check_answer(start, scenes::from_reference(literal), run,
                                           first + reference_steps, reference_area_limit);
        state.SetIterationTime(run.wall_s);
        report(state, c, run, answer, load);
        reference_times()[c.family].push_back(run.wall_s * 1e6 / run.steps);
    }
}

void add(const Case& c) {
    benchmark::RegisterBenchmark(name_of(c).c_str(),
                                 [c](benchmark::State& state) {
                                     guarded(state, [&c](benchmark::State& s) {
                                         if (c.modelled) {
                                             measure_model(s, c);
                                         } else if (c.strategy == Strategy::reference) {
                                             measure_reference(s, c);
                                         } else {
                                             measure(s, c);
                                         }
                                     });
                                 })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

/// The same number for any number of threads, if possible; 0: as many cells as are worth while.
std::uint32_t submeshes_of(Strategy strategy, std::uint32_t threads) {
    if (strategy == Strategy::cells) {
        return 0;
    }
    return std::max(strategy == Strategy::blocks ? 2 * slabs : slabs, threads);
}

// A cell for each thread, and no more: the least boundary that so many can have.
void add_few_cells(const std::string& family, int triangles) {
    for (const std::uint32_t threads : thread_counts()) {
        add({family, triangles, Strategy::cells, core_count(), threads});
    }
}

// The measured thread counts, where the model can be checked, and larger ones.
void add_modelled(const std::string& family, int triangles, Strategy strategy) {
    for (const std::uint32_t threads : {1U, 2U, 4U, 8U, 16U, 32U}) {
        add({family, triangles, strategy, submeshes_of(strategy, threads), threads, true});
    }
    if (strategy == Strategy::cells) {
        // As many cells as threads, which is not the best number for most of them.
        for (const std::uint32_t threads : {4U, 8U, 16U, 32U}) {
            add({family, triangles, strategy, threads, threads, true});
        }
    }
}

} // namespace

void register_steps() {
    for (const char* family : {"scaling_step", "four_circles_step"}) {
        for (const int triangles : {small_mesh, 280000, 2800000}) {
            if (triangles == small_mesh) {
                add({family, triangles, Strategy::reference});
            }
            add({family, triangles, Strategy::sequential});
            for (const Strategy strategy : {Strategy::fixed, Strategy::counting, Strategy::active,
                                            Strategy::blocks, Strategy::cells}) {
                for (const std::uint32_t threads : thread_counts()) {
                    add({family, triangles, strategy, submeshes_of(strategy, threads), threads});
                }
            }
            add_few_cells(family, triangles);
            if (triangles < 1000000) {
                // With larger meshes, copying takes seconds per step and shows nothing new.
                for (const std::uint32_t threads : thread_counts()) {
                    add({family, triangles, Strategy::copy, slabs, threads});
                }
            }
            for (const Strategy strategy : {Strategy::active, Strategy::cells}) {
                add_modelled(family, triangles, strategy);
            }
        }
    }
    // The same scene with less and more to do in a step.
    for (const int triangles : {1800, 3500, 7000, 14000, small_mesh, 56000, 112000, 280000}) {
        add({"granularity_step", triangles, Strategy::sequential});
        for (const std::uint32_t threads : thread_counts()) {
            add({"granularity_step", triangles, Strategy::cells, 0, threads});
        }
    }
    for (const int triangles : {swirl_mesh, fine_swirl_mesh}) {
        add({"swirl_step", triangles, Strategy::sequential});
        for (const std::uint32_t threads : thread_counts()) {
            add({"swirl_step", triangles, Strategy::cells, 0, threads});
        }
        add_modelled("swirl_step", triangles, Strategy::cells);
    }
}

} // namespace dsc::bench
