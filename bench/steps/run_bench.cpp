// SPDX-License-Identifier: MIT
// Whole runs of any scene, as in an application: construction of the simulation and all steps, with
// other work of the application between two steps. The counter `us_per_step` is the mean time of
// all steps, without the work between them; the first run of the process is not timed, so that code
// and memory are warm in all runs.
#include "steps/context.h"
#include "steps/refusal.h"
#include "steps/step_run.h"
#include "steps/suites.h"

#include "dsc/base/error.h"
#include "replay/mesh_hash.h"
#include "scenes/run/dsc_method.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>

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

// Other work of the application: only the caller's core is busy.
void work_for(int microseconds) {
    const auto begin = Clock::now();
    while (Clock::now() - begin < std::chrono::microseconds(microseconds)) {
    }
}

WholeRun run_whole(const Row& row, std::uint32_t threads, int between_us,
                   const std::function<void(const Complex<double>&, const StepRun&)>& look) {
    const Start& start = *row.start;
    Complex<double> complex = start.complex;
    WholeRun run;
    const auto begin = Clock::now();
    scenes::DscMethod<double> method(start.setup, start.parameters, row.options(threads),
                                     std::move(complex));
    run.construction_s = seconds_since(begin);
    scenes::RunResult result;
    for (int step = 0; step < start.setup.steps && result.gave_up.empty(); ++step) {
        work_for(between_us);
        const auto step_begin = Clock::now();
        method.step(step * start.setup.dt, (step + 1) * start.setup.dt, result);
        const double seconds = seconds_since(step_begin);
        run.first_step_s = step == 0 ? seconds : run.first_step_s;
        run.steps_s += seconds;
        run.steps.threads_used = std::max(run.steps.threads_used, method.threads_used());
        run.steps.vertex_steps += static_cast<double>(method.interface_vertices());
    }
    run.steps.steps = start.setup.steps;
    run.steps.unreached = result.unreached;
    run.steps.gave_up = !result.gave_up.empty();
    add_work(run.steps, method.executor(), 1);
    run.steps.busy_s += run.steps_s;
    look(method.complex(), run.steps);
    return run;
}

// The run that is not timed, on one thread.
Answer run_once(const Row& row) {
    const Start& start = *row.start;
    Answer answer;
    run_whole(row, 1, 0, [&](const Complex<double>& complex, const StepRun& run) {
        answer = check_answer(start, complex, run, run.steps, start.area_limit);
    });
    return answer;
}

void measure_run(benchmark::State& state, const Row& row) {
    const Answer& expected = answer_of(row, [&] { return run_once(row); });
    const auto check = [&](const Complex<double>& complex, const StepRun& run) {
        if (run.unreached > 0 || run.gave_up || mesh_hash(complex) != expected.hash) {
            throw InvariantError("the mesh is not that of a run with one thread");
        }
    };
    for (auto _ : state) {
        const double load = other_load();
        const WholeRun run = run_whole(row, row.threads, row.between_us, check);
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
