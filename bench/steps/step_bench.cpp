// SPDX-License-Identifier: MIT
// A time step (thesis, section 9.7), by every strategy from the same complex. An iteration has
// `timed_steps` steps; the counter `us_per_step` is the time of one. S(n) is the ratio of the row
// `strategy:sequential` to the row with `threads:n`, of the same family and size.
#include "steps/context.h"
#include "steps/memory.h"
#include "steps/model_counters.h"
#include "steps/refusal.h"
#include "steps/step_run.h"
#include "steps/suites.h"

#include "dsc/base/error.h"
#include "replay/mesh_hash.h"
#include "scenes/run/reference_run.h"
#include "scenes/run/start.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace dsc::bench {

namespace {

using scenes::Strategy;

constexpr int reference_steps = 3;
constexpr double reference_area_limit = 0.01;

// A copy with spare capacity, as in a running simulation.
Complex<double> copy_with_room(const Complex<double>& complex) {
    Complex<double> copy;
    const auto roomy = [](std::size_t n) { return n + n / 16 + 4096; };
    copy.reserve(roomy(complex.vertices.size()), roomy(complex.triangles.size()));
    copy = complex;
    return copy;
}

/// The mesh after the steps of a row on one thread: the result of every measurement must be bitwise
/// identical.
const Answer& answer_of_steps(const Row& row) {
    return answer_of(row, [&row] {
        const Start& start = *row.start;
        Complex<double> complex = copy_with_room(start.complex);
        const StepRun run = run_steps(start, complex, row.options(1));
        return check_answer(start, complex, run, start.step + warm_up_steps + timed_steps,
                            start.area_limit);
    });
}

/// The times of the literal method so far, for the ratio; empty if it has not run.
std::map<const Start*, std::vector<double>>& reference_times() {
    static std::map<const Start*, std::vector<double>> times;
    return times;
}

void report(benchmark::State& state, const Row& row, const StepRun& run, const Answer& answer,
            double load) {
    count(state, row, run, run.wall_s, answer, load);
    state.counters["cpu_us_per_step"] = run.cpu_s * 1e6 / run.steps;
}

void measure(benchmark::State& state, const Row& row) {
    const Start& start = *row.start;
    const Answer& expected = answer_of_steps(row);
    for (auto _ : state) {
        Complex<double> complex = copy_with_room(start.complex);
        const double load = other_load();
        const PeakMemory memory;
        const StepRun run = run_steps(start, complex, row.options(row.threads));
        const double peak_mb = memory.mb() - starts_mb();
        if (run.unreached > 0 || run.gave_up || mesh_hash(complex) != expected.hash) {
            throw InvariantError("the mesh is not that of a run with one thread");
        }
        state.SetIterationTime(run.wall_s);
        report(state, row, run, expected, load);
        auto& counters = state.counters;
        counters["peak_memory_mb"] = peak_mb;
        const auto per_step = [&](std::uint64_t count) {
            return static_cast<double>(count) / run.steps;
        };
        const OperationCounts& did = run.operations;
        counters["examined_per_step"] = per_step(did.examined);
        counters["flips_per_step"] = per_step(did.flips);
        counters["splits_per_step"] = per_step(did.splits + did.interface_splits);
        counters["collapses_per_step"] = per_step(did.collapses + did.interface_collapses);
        const auto& reference = reference_times()[&start];
        if (row.strategy == Strategy::sequential && !reference.empty()) {
            counters["speedup_vs_reference"] = median(reference) / (run.wall_s * 1e6 / run.steps);
        }
    }
}

/// The steps of a row on this number of threads, with the times of their tasks.
ModelRun account_of(const Row& row, std::uint32_t threads) {
    Complex<double> complex = copy_with_room(row.start->complex);
    const PeakMemory memory; // returns free memory to the system, as before the measured steps
    ModelRun run = profile_steps(*row.start, complex, row.options(threads));
    if (mesh_hash(complex) != answer_of_steps(row).hash) {
        throw InvariantError("the mesh is not that of a run without an account of times");
    }
    return run;
}

void measure_model(benchmark::State& state, const Row& row) {
    for (auto _ : state) {
        const double load = other_load();
        static const double fork_join = measure_fork_join(core_count());
        static const double bandwidth_of_one = measure_bandwidth(1);
        static const double bandwidth_of_all = measure_bandwidth(core_count());
        const std::uint32_t at_work = row.threads > 1 ? core_count() : 1;
        const ModelRun run = account_of(row, at_work);
        const double start = std::max(fork_join, measured_start(run, at_work));
        const ModelTimes times = model(run, row.threads, start);
        count_model(state, times, start, fork_join, timed_steps);
        const auto per_step = [](double seconds) { return seconds * 1e6 / timed_steps; };
        auto& counters = state.counters;
        counters["bandwidth_of_one_gb_s"] = bandwidth_of_one * 1e-9;
        counters["bandwidth_of_all_gb_s"] = bandwidth_of_all * 1e-9;
        counters["load"] = load;
        // The parts of the time of a step, summed over submeshes.
        const ModelAccount& total = run.account;
        counters["us_all_tasks"] = per_step(total.tasks);
        counters["us_set_up"] = per_step(total.set_up);
        counters["us_hand_over"] = per_step(total.hand_over);
        counters["us_clean_up"] = per_step(total.clean_up);
        counters["us_remeshing"] = per_step(total.remeshing);
        counters["us_velocities"] = per_step(total.targets - total.remeshing);
        counters["us_movement"] = per_step(total.movement);
        counters["us_mesh_update"] = per_step(total.mesh_update);
        counters["us_later_colours"] = per_step(total.later);
        double outside = 0;
        for (const double seconds : run.serial_outside) {
            outside += seconds;
        }
        counters["us_driver"] = per_step(outside);
    }
}

// The literal method needs no warm-up, because it sweeps the whole mesh in each step. It starts in
// the middle of the timed steps of the others, so that its interface is as long as theirs on
// average.
void measure_reference(benchmark::State& state, const Row& row) {
    const Start& start = *row.start;
    const int first = start.step + warm_up_steps + timed_steps / 2;
    static std::map<const Start*, Complex<double>> half_way;
    auto& complex = half_way[&start];
    if (complex.triangle_count() == 0) {
        complex = start.complex;
        const auto options = scenes::scene_options<double>(start.setup, start.parameters);
        Simulation<double> simulation(complex, options);
        for (int step = start.step; step < first; ++step) {
            advance(simulation, start.setup, step);
        }
    }
    for (auto _ : state) {
        reference::Complex literal = scenes::to_reference(complex);
        const double load = other_load();
        const StepRun run = run_reference(start, literal, first, reference_steps);
        const Answer answer = check_answer(start, scenes::from_reference(literal), run,
                                           first + reference_steps, reference_area_limit);
        state.SetIterationTime(run.wall_s);
        report(state, row, run, answer, load);
        reference_times()[&start].push_back(run.wall_s * 1e6 / run.steps);
    }
}

} // namespace

void register_step(const Row& row) {
    add_long_row(row.name, [row](benchmark::State& state) {
        make_ready(*row.start);
        if (row.measure == Measure::model) {
            measure_model(state, row);
        } else if (row.strategy == Strategy::reference) {
            measure_reference(state, row);
        } else {
            measure(state, row);
        }
    });
}

} // namespace dsc::bench
