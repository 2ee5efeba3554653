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
#include "dsc/queries/hash.h"
#include "scenes/catalogue/catalogue.h"
#include "scenes/run/start.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace dsc::bench {

namespace {

using Clock = std::chrono::steady_clock;
using scenes::Strategy;

struct RunCase {
    std::string family;
    std::string scene;
    int triangles; ///< about so many in the unit square
    Strategy strategy;
    std::uint32_t threads = 1;
    int between_us = 0; ///< other work of the application before each step
};

/// The beginning of a scene, for all strategies.
struct Beginning {
    Start start; ///< step 0
    double area_limit = 0;
};

struct WholeRun {
    double construction_s = 0;
    double first_step_s = 0;
    double steps_s = 0; ///< of all steps
    StepRun steps;
};

std::string name_of(const RunCase& c) {
    std::string name = c.family + "/strategy:" + scenes::to_string(c.strategy) +
                       "/triangles:" + std::to_string(c.triangles);
    if (c.strategy != Strategy::sequential) {
        name += "/threads:" + std::to_string(c.threads);
    }
    return name + "/between_us:" + std::to_string(c.between_us);
}

const Beginning& beginning_of(const RunCase& c) {
    static std::map<std::pair<std::string, int>, std::unique_ptr<const Beginning>> all;
    auto& known = all[{c.family, c.triangles}];
    if (!known) {
        auto made = std::make_unique<Beginning>();
        const scenes::Scene& scene = scenes::find_scene(c.scene);
        Start& start = made->start;
        start.family = c.family;
        start.parameters = scene.defaults;
        start.parameters.h = std::sqrt(4 / (std::sqrt(3.0) * c.triangles));
        start.setup = scene.prepare(start.parameters);
        start.parameters.dt = start.setup.dt;
        start.complex = scenes::first_complex<double>(start.setup, start.parameters);
        made->area_limit = area_limit(start);
        known = std::move(made);
    }
    return *known;
}

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Other work of the application: the caller's core is busy, the others have nothing to do.
void work_for(int microseconds) {
    const auto begin = Clock::now();
    while (Clock::now() - begin < std::chrono::microseconds(microseconds)) {
    }
}

WholeRun run_whole(const Start& start, Complex<double>& complex, const RunCase& c) {
    const Options<double> options = scenes::scene_options<double>(start.setup, start.parameters);
    scenes::Submeshing submeshing;
    submeshing.threads = c.threads;
    WholeRun run;
    const auto begin = Clock::now();
    const auto simulation = scenes::make_simulation(
        complex, options, scenes::topology_options<double>(start.parameters), c.strategy,
        submeshing);
    run.construction_s = seconds_since(begin);
    const auto& velocity = start.setup.flow.front().velocity;
    const double dt = start.parameters.dt;
    for (int step = 0; step < start.setup.steps; ++step) {
        work_for(c.between_us);
        const auto step_begin = Clock::now();
        const StepReport report = simulation->step(velocity, step * dt, dt);
        const double seconds = seconds_since(step_begin);
        run.first_step_s = step == 0 ? seconds : run.first_step_s;
        run.steps_s += seconds;
        run.steps.vertex_steps += report.interface_vertices;
        run.steps.unreached += report.unreached;
        run.steps.gave_up = run.steps.gave_up || report.gave_up != GiveUp::none;
    }
    run.steps.steps = start.setup.steps;
    return run;
}

// The result of a strategy, computed once on one thread, checked and kept: it is the run that is
// not timed, and every measurement must give the same bits.
const Answer& answer_of(const RunCase& c) {
    static std::map<std::tuple<std::string, int, Strategy>, Answer> answers;
    const std::tuple key{c.family, c.triangles, c.strategy};
    if (const auto known = answers.find(key); known != answers.end()) {
        return known->second;
    }
    const Beginning& beginning = beginning_of(c);
    Complex<double> complex = beginning.start.complex;
    RunCase once = c;
    once.threads = 1;
    once.between_us = 0;
    const WholeRun run = run_whole(beginning.start, complex, once);
    return answers
        .emplace(key, check_answer(beginning.start, complex, run.steps, run.steps.steps,
                                   beginning.area_limit))
        .first->second;
}

void measure(benchmark::State& state, const RunCase& c) {
    const Answer& expected = answer_of(c);
    const Beginning& beginning = beginning_of(c);
    for (auto _ : state) {
        Complex<double> complex = beginning.start.complex;
        const double load = other_load();
        const WholeRun run = run_whole(beginning.start, complex, c);
        if (run.steps.unreached > 0 || run.steps.gave_up || mesh_hash(complex) != expected.hash) {
            throw InvariantError("the mesh is not that of a run with one thread");
        }
        state.SetIterationTime(run.steps_s);
        auto& counters = state.counters;
        counters["us_per_step"] = run.steps_s * 1e6 / run.steps.steps;
        counters["construction_us"] = run.construction_s * 1e6;
        counters["first_step_us"] = run.first_step_s * 1e6;
        counters["us_per_vertex_step"] = run.steps_s * 1e6 / run.steps.vertex_steps;
        counters["interface_vertices"] = run.steps.vertex_steps / run.steps.steps;
        counters["triangles"] = static_cast<double>(expected.triangles);
        counters["min_quality"] = expected.min_quality;
        counters["area_error_rel"] = expected.area_error_rel;
        counters["load"] = load;
        counters["oversubscribed"] = c.threads > core_count() ? 1 : 0;
    }
}

void add(const RunCase& c) {
    benchmark::RegisterBenchmark(name_of(c).c_str(),
                                 [c](benchmark::State& state) {
                                     guarded(state, [&c](benchmark::State& s) { measure(s, c); });
                                 })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
}

} // namespace

void register_runs() {
    struct Family {
        const char* name;
        const char* scene;
        int triangles;
        std::vector<int> between_us;
    };
    const std::vector<Family> families{
        {"scaling_run", "speedup-scaling", 28000, {0, 100, 1000, 5000}},
        {"scaling_run", "speedup-scaling", 280000, {0, 1000}},
        {"four_circles_run", "speedup-four-circles", 28000, {0, 1000}},
        {"four_circles_run", "speedup-four-circles", 280000, {0}},
    };
    for (const Family& family : families) {
        for (const int between_us : family.between_us) {
            RunCase c{family.name, family.scene, family.triangles, Strategy::sequential,
                      1,           between_us};
            add(c);
            c.strategy = Strategy::cells;
            for (const std::uint32_t threads : thread_counts()) {
                c.threads = threads;
                add(c);
            }
        }
    }
}

} // namespace dsc::bench
