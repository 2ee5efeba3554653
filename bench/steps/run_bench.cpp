// SPDX-License-Identifier: MIT
// Whole runs of a scene, as an application makes them: a simulation is constructed, its first step
// is done, then all the others, with other work of the application between two steps. The counter
// `us_per_step` is the sum of all steps over their number, without what lies between them; the
// first run of the process is not timed, so that all runs find their code and memory in use.
#include "context.h"
#include "refusal.h"
#include "step_run.h"
#include "suites.h"

#include "dsc/base/error.h"
#include "replay/mesh_hash.h"
#include "scenes/run/start.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

namespace dsc::bench {

namespace {

using Clock = std::chrono::steady_clock;

struct WholeRun {
    double construction_s = 0;
    double first_step_s = 0;
    double steps_s = 0; ///< of all steps
    StepRun steps;
};

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Other work of the application: the caller's core is busy, the others have nothing to do.
void work_for(int microseconds) {
    const auto begin = Clock::now();
    while (Clock::now() - begin < std::chrono::microseconds(microseconds)) {
    }
}

WholeRun run_whole(const Start& start, Complex<double>& complex, const scenes::RunOptions& options,
                   int between_us) {
    const auto choices = scenes::scene_options<double>(start.setup, start.parameters);
    WholeRun run;
    const auto begin = Clock::now();
    const Prepared made = prepare(start, complex, choices, options.strategy, options.submeshing);
    run.construction_s = seconds_since(begin);
    for (int step = 0; step < start.setup.steps; ++step) {
        work_for(between_us);
        const auto step_begin = Clock::now();
        const StepReport report = advance(*made.simulation, start.setup, step);
        const double seconds = seconds_since(step_begin);
        run.first_step_s = step == 0 ? seconds : run.first_step_s;
        run.steps_s += seconds;
        run.steps.threads_used = std::max(run.steps.threads_used, made.threads_used());
        run.steps.vertex_steps += report.interface_vertices;
        run.steps.unreached += report.unreached;
        run.steps.gave_up = run.steps.gave_up || report.gave_up != GiveUp::none;
    }
    run.steps.steps = start.setup.steps;
    made.add_work(run.steps, 1);
    run.steps.busy_s += run.steps_s;
    return run;
}

// On one thread: it is the run that is not timed.
Answer run_once(const Row& row) {
    const Start& start = *row.start;
    Complex<double> complex = start.complex;
    const WholeRun run = run_whole(start, complex, row.options(1), 0);
    return check_answer(start, complex, run.steps, run.steps.steps, start.area_limit);
}

void measure_run(benchmark::State& state, const Row& row) {
    const Start& start = *row.start;
    const Answer& expected = answer_of(row, [&] { return run_once(row); });
    for (auto _ : state) {
        Complex<double> complex = start.complex;
        const double load = other_load();
        const WholeRun run = run_whole(start, complex, row.options(row.threads), row.between_us);
        if (run.steps.unreached > 0 || run.steps.gave_up || mesh_hash(complex) != expected.hash) {
            throw InvariantError("the mesh is not that of a run with one thread");
        }
        state.SetIterationTime(run.steps_s);
        count(state, row, run.steps, run.steps_s, expected, load);
        state.counters["construction_us"] = run.construction_s * 1e6;
        state.counters["first_step_us"] = run.first_step_s * 1e6;
    }
}

} // namespace

void register_run(const Row& row) {
    add_long_row(row.name, [row](benchmark::State& state) {
        make_ready(*row.start);
        measure_run(state, row);
    });
}

} // namespace dsc::bench
