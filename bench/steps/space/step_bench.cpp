// SPDX-License-Identifier: MIT
// Whole runs in three dimensions, whose exact results are known.
#include "steps/refusal.h"
#include "steps/suites.h"

#include "dsc/base/error.h"
#include "scenes/space/run.h"

#include <benchmark/benchmark.h>

#include <string>

namespace dsc::bench {

namespace {

void measure(benchmark::State& state, const std::string& name, int edges, double farthest) {
    const scenes::space::Scene* const scene = scenes::space::find_scene(name);
    scenes::Parameters parameters = scene->defaults;
    parameters.h = 1.0 / edges;
    for (auto _ : state) {
        const scenes::space::RunResult result = scenes::space::run_scene(*scene, parameters, {});
        if (!result.holds() || !(result.vertex_error_max.value() <= farthest * parameters.h)) {
            throw InvariantError("an invariant is broken, or a vertex is off the exact shape");
        }
        state.SetIterationTime(result.cpu_s);
        state.counters["interface_vertices"] = result.interface_vertices_max;
        state.counters["us_per_step"] = 1e6 * result.cpu_s / result.steps;
        state.counters["us_per_vertex_and_sub_step"] =
            1e6 * result.cpu_s / static_cast<double>(result.sum.moves);
        state.counters["us_per_tet_and_step"] =
            1e6 * result.cpu_s / static_cast<double>(result.tet_steps);
        state.counters["vertices_off_h"] = *result.vertex_error_max / parameters.h;
    }
    state.SetLabel("CPU time of a run");
}

} // namespace

void register_space() {
    const auto add = [](const std::string& scene, int edges, double farthest) {
        add_long_row("space/" + scene + "/edges:" + std::to_string(edges),
                     [=](benchmark::State& state) { measure(state, scene, edges, farthest); });
    };
    for (const int edges : {16, 32}) {
        add("translation-3d", edges, 1e-9);
    }
    for (const int edges : {24, 32}) {
        add("enright", edges, 1); // its film is thinner than half an edge
    }
}

} // namespace dsc::bench
