// SPDX-License-Identifier: MIT
// The cost of a velocity for one position: the built-in swirl, and the swirl by formulas of a scene
// file, written in two ways. Built-in flow and formula alternate within an iteration, so that
// disturbances affect both; the counter `ratio` is that of their sums.
#include "steps/refusal.h"
#include "steps/suites.h"

#include "dsc/base/error.h"
#include "flows/velocity.h"
#include "scenes/file/formula/formula_flow.h"
#include "scenes/run/clock.h"

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace dsc::bench {

namespace {

/// The number of interface vertices of a typical scene, evaluated often enough for the clock.
constexpr std::size_t positions_of_front = 512;
constexpr int evaluations = 200;
constexpr double rounding = 4e-15;

std::vector<Point<double>> random_positions() {
    std::mt19937_64 random(1);
    std::vector<Point<double>> positions(positions_of_front);
    for (Point<double>& p : positions) {
        const auto unit = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
        const double x = unit();
        p = {x, unit()};
    }
    return positions;
}

double seconds(const scenes::Velocity& flow, const std::vector<Point<double>>& positions,
               std::vector<Point<double>>& velocities) {
    const scenes::Stopwatch watch;
    for (int i = 0; i < evaluations; ++i) {
        flow(positions, 0.0, velocities);
        benchmark::DoNotOptimize(velocities.data());
        benchmark::ClobberMemory();
    }
    return watch.cpu();
}

void measure_formula(benchmark::State& state, const scenes::FormulaTexts& texts) {
    const auto positions = random_positions();
    std::vector<Point<double>> built_in(positions.size());
    std::vector<Point<double>> by_formula(positions.size());
    const scenes::Velocity swirl = scenes::Swirl{};
    const scenes::Velocity formula = scenes::FormulaFlow(texts);
    double of_swirl = 0;
    double of_formula = 0;
    for (auto _ : state) {
        of_swirl += seconds(swirl, positions, built_in);
        const double time = seconds(formula, positions, by_formula);
        of_formula += time;
        state.SetIterationTime(time);
    }
    for (std::size_t i = 0; i < built_in.size(); ++i) {
        if (!((by_formula[i] - built_in[i]).norm() < rounding)) {
            throw InvariantError("the formula is not the swirl");
        }
    }
    const auto items = static_cast<std::int64_t>(positions_of_front) * evaluations;
    state.SetItemsProcessed(state.iterations() * items);
    state.SetLabel("CPU time of a batch");
    state.counters["ratio"] = of_formula / of_swirl;
}

} // namespace

void register_flows() {
    const auto add = [](const char* name, const scenes::FormulaTexts& texts) {
        add_row(name, [texts](benchmark::State& state) {
            measure_formula(state, texts);
        })->Unit(benchmark::kMicrosecond);
    };
    add("flow/swirl_by_products", {.u = "2 * sin(pi*x)^2 * sin(pi*y) * cos(pi*y)",
                                   .v = "-2 * sin(pi*y)^2 * sin(pi*x) * cos(pi*x)"});
    add("flow/swirl_by_double_angles",
        {.u = "sin(pi*x)^2 * sin(2*pi*y)", .v = "-sin(pi*y)^2 * sin(2*pi*x)"});
}

} // namespace dsc::bench
