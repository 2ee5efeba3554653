// SPDX-License-Identifier: MIT
#include "steps/step_run.h"

#include "steps/context.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/error.h"
#include "dsc/base/timer.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/in_place/schedule.h"
#include "dsc/parallel/submesh_view.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"
#include "dsc/queries/validate.h"
#include "measures/interface_outlines.h"
#include "measures/mesh_quality.h"
#include "replay/mesh_hash.h"
#include "scenes/run/clock.h"
#include "scenes/run/reference_run.h"
#include "scenes/run/start.h"
#include "topology/stage.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

namespace dsc::bench {

namespace {

// Idle cores run slowly at first, and a measurement takes only a few milliseconds. All threads are
// kept busy for a while before, so that all rows are measured at the same clock rate.
void wake(std::uint32_t threads) {
    constexpr double seconds = 0.03;
    ThreadPool pool;
    pool.start(threads);
    Schedule schedule;
    schedule.tasks.add_colour(threads);
    const auto begin = std::chrono::steady_clock::now();
    const auto since = [begin] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    while (since() < seconds) {
        schedule.run(pool, threads, Assignment::fixed, [](std::size_t) {
            const auto start = std::chrono::steady_clock::now();
            while (std::chrono::steady_clock::now() - start < std::chrono::microseconds(50)) {
            }
        });
    }
}

/// NaN if it is unknown.
double exact_area(const Start& start, int step) {
    return start.setup.exact ? start.setup.exact(step * start.parameters.dt).area
                             : std::numeric_limits<double>::quiet_NaN();
}

/// Seconds in the passes of submeshes; several threads add to them.
struct PassTimes {
    std::atomic<double> remeshing = 0;
    std::atomic<double> movement = 0;
    std::atomic<double> mesh_update = 0;
};

// Wraps a pass to add up its times in submeshes of the first colour, which are the only ones with
// lists of interface vertices.
void time_pass(Pass<double>& pass, std::atomic<double>& seconds) {
    pass.run = [&seconds, run = std::move(pass.run)](Work<double>& work) {
        const bool counts = !work.submesh.region.is_whole() && !work.interface.empty();
        Timer timer(counts);
        run(work);
        if (counts) {
            seconds.fetch_add(timer.lap());
        }
    };
}

// `times` must outlive the algorithm.
Algorithm<double> timed_algorithm(PassTimes& times) {
    Algorithm<double> algorithm = default_algorithm<double>();
    time_pass(algorithm.remeshing.at(0), times.remeshing);
    time_pass(algorithm.motion.at(0), times.movement);
    time_pass(algorithm.motion.at(1), times.mesh_update);
    return algorithm;
}

void add(StepRun& run, const StepReport& report) {
    run.unreached += report.unreached;
    run.gave_up = run.gave_up || report.gave_up != GiveUp::none;
}

} // namespace

Prepared prepare(const Start& start, Complex<double>& complex, const Options<double>& choices,
                 scenes::Strategy strategy, const scenes::Submeshing& submeshing,
                 const Algorithm<double>* algorithm) {
    auto executor = scenes::make_executor(complex, choices, strategy, submeshing, algorithm);
    const Executor<double>& seen = *executor;
    auto simulation = std::make_unique<Simulation<double>>(complex, choices, std::move(executor));
    if (const auto topology = scenes::topology_options<double>(start.parameters);
        topology.changes()) {
        simulation->add_stage(std::make_shared<TopologyStage<double>>(topology));
    }
    return {std::move(simulation), seen};
}

void add_work(StepRun& run, const Executor<double>& executor, double sign) {
    const auto submeshes = submeshes_in(executor);
    run.busy_s +=
        submeshes ? sign * submeshes->work.beyond_one() : std::numeric_limits<double>::quiet_NaN();
    run.sections_s += submeshes ? sign * submeshes->work.sections_s : 0;
}

std::uint32_t Prepared::threads_used() const {
    const auto submeshes = submeshes_in(executor);
    return submeshes ? submeshes->threads_used : 1;
}

StepRun run_steps(const Start& start, Complex<double>& complex, const scenes::RunOptions& options) {
    const auto choices = scenes::scene_options<double>(start.setup, start.parameters);
    const Prepared made = prepare(start, complex, choices, options.strategy, options.submeshing);
    Simulation<double>& simulation = *made.simulation;
    StepRun run;
    run.steps = timed_steps;
    int step = start.step;
    wake(options.submeshing.threads);
    for (int i = 0; i < warm_up_steps; ++i, ++step) {
        add(run, advance(simulation, start.setup, step));
    }
    add_work(run, made.executor, -1);
    const scenes::Stopwatch watch;
    for (int i = 0; i < timed_steps; ++i, ++step) {
        const StepReport report = advance(simulation, start.setup, step);
        run.threads_used = std::max(run.threads_used, made.threads_used());
        run.vertex_steps += report.interface_vertices;
        run.operations += report.operations;
        add(run, report);
    }
    run.wall_s = watch.wall();
    run.cpu_s = watch.cpu();
    add_work(run, made.executor, 1);
    run.busy_s += run.wall_s;
    return run;
}

ModelRun profile_steps(const Start& start, Complex<double>& complex,
                       const scenes::RunOptions& options) {
    const auto choices = scenes::scene_options<double>(start.setup, start.parameters);
    scenes::Submeshing submeshing = options.submeshing;
    submeshing.profile = true;
    submeshing.always_all_threads = true; // even if fewer are as fast
    PassTimes times;
    const Algorithm<double> algorithm = timed_algorithm(times);
    const Prepared made =
        prepare(start, complex, choices, options.strategy, submeshing, &algorithm);
    if (!submeshes_in(made.executor)) {
        throw InvariantError("this strategy does not measure the times of its tasks");
    }
    ModelRun run;
    int step = start.step;
    wake(submeshing.threads);
    for (int i = 0; i < warm_up_steps + timed_steps; ++i, ++step) {
        if (i == warm_up_steps) {
            times.remeshing = times.movement = times.mesh_update = 0;
        }
        const auto begin = std::chrono::steady_clock::now();
        (void)advance(*made.simulation, start.setup, step);
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
        if (i >= warm_up_steps) {
            add_step(run, *submeshes_in(made.executor), wall.count());
        }
    }
    run.account.remeshing = times.remeshing;
    run.account.movement = times.movement;
    run.account.mesh_update = times.mesh_update;
    return run;
}

StepRun run_reference(const Start& start, reference::Complex& complex, int first, int steps) {
    const reference::Options options = scenes::reference_options(start.parameters);
    const double dt = start.parameters.dt;
    StepRun run;
    run.steps = steps;
    const scenes::Stopwatch watch;
    for (int step = first; step < first + steps; ++step) {
        const auto& velocity =
            scenes::velocity_of_step(start.setup.flow, step * dt, (step + 1) * dt);
        const reference::Velocity one = [&velocity](const Point<double>& p, double time) {
            Point<double> v;
            velocity({&p, 1}, time, {&v, 1});
            return v;
        };
        const reference::StepCounts counts = reference::step(complex, one, step * dt, dt, options);
        // Each interface vertex arrives once in each sub-step.
        run.vertex_steps += static_cast<double>(counts.moved + counts.unreached) /
                            static_cast<double>(counts.substeps);
        run.unreached += counts.unreached;
    }
    run.wall_s = watch.wall();
    run.cpu_s = watch.cpu();
    return run;
}

Answer check_answer(const Start& start, const Complex<double>& complex, const StepRun& run,
                    int step, double limit) {
    if (run.unreached > 0 || run.gave_up) {
        throw InvariantError(std::to_string(run.unreached) + " vertices did not arrive");
    }
    validate_or_throw(complex);
    const scenes::MeshQuality quality = scenes::measure_worst(complex);
    if (quality.inverted > 0) {
        throw InvariantError(std::to_string(quality.inverted) + " triangles are inverted");
    }
    Answer answer;
    answer.hash = mesh_hash(complex);
    answer.triangles = complex.triangle_count();
    answer.min_quality = quality.min_quality;
    const double exact = exact_area(start, step);
    const double area =
        scenes::signed_area(scenes::interface_outlines(complex, {.phase = start.setup.measured}));
    answer.area_error_rel = std::abs((area - exact) / exact);
    if (!std::isnan(exact) && !(answer.area_error_rel <= limit)) {
        throw InvariantError("the area is off by " + std::to_string(answer.area_error_rel) +
                             " of the exact one, where " + std::to_string(limit) + " is allowed");
    }
    return answer;
}

const Answer& answer_of(const Row& row, const std::function<Answer()>& compute) {
    using Key = std::tuple<const Start*, scenes::Strategy, std::uint32_t>;
    static std::map<Key, Answer> answers;
    const Key key{row.start.get(), row.strategy, row.submeshes};
    const auto known = answers.find(key);
    return known != answers.end() ? known->second : answers.emplace(key, compute()).first->second;
}

void count(benchmark::State& state, const Row& row, const StepRun& run, double seconds,
           const Answer& answer, double load) {
    auto& counters = state.counters;
    counters["us_per_step"] = seconds * 1e6 / run.steps;
    counters["us_per_vertex_step"] = seconds * 1e6 / run.vertex_steps;
    counters["interface_vertices"] = run.vertex_steps / run.steps;
    counters["triangles"] = static_cast<double>(answer.triangles);
    counters["min_quality"] = answer.min_quality;
    if (!std::isnan(answer.area_error_rel)) {
        counters["area_error_rel"] = answer.area_error_rel;
    }
    counters["load"] = load;
    counters["threads_used"] = run.threads_used;
    const double busy_s = scenes::is_parallel(row.strategy) ? run.busy_s : seconds;
    if (!std::isnan(busy_s)) {
        counters["utilisation"] = busy_s / (row.threads * seconds);
        counters["serial_share"] = (seconds - run.sections_s) / busy_s; // of the work
    }
    counters["oversubscribed"] = row.threads > core_count() ? 1 : 0;
}

} // namespace dsc::bench
