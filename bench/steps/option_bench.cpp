// SPDX-License-Identifier: MIT
// The cost of an option in a step: the same scene with and without it, in alternating runs, so that
// disturbances affect both. The counter `ratio` is that of the sums, over all steps, of the
// shortest time of the step in any run: noise can only make times longer.
#include "steps/refusal.h"
#include "steps/step_run.h"
#include "steps/suites.h"

#include "dsc/base/error.h"
#include "replay/mesh_hash.h"
#include "scenes/run/start.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <string>
#include <vector>

namespace dsc::bench {

namespace {

using scenes::Parameters;

constexpr int rounds = 15;
constexpr int max_steps = 200;

/// One of the two compared runs: its start, and the times of its steps.
class Side {
public:
    Side(const scenes::Scene& scene, const Parameters& parameters)
        : setup_(scene.prepare(parameters)),
          complex_(scenes::first_complex<double>(setup_, parameters)),
          options_(scenes::scene_options<double>(setup_, parameters)),
          topology_(scenes::topology_options<double>(parameters)),
          min_(static_cast<std::size_t>(std::min(setup_.steps, max_steps)), 1e9) {}

    /// Makes a run from the start. Throws InvariantError if a vertex does not arrive.
    void run() {
        using Clock = std::chrono::steady_clock;
        Complex<double> complex = complex_;
        const auto simulation =
            scenes::make_simulation(complex, options_, topology_, scenes::Strategy::sequential, {});
        double sum = 0;
        for (std::size_t step = 0; step < min_.size(); ++step) {
            const double time = static_cast<double>(step) * setup_.dt;
            const auto& velocity = scenes::velocity_of_step(setup_.flow, time, time + setup_.dt);
            const auto begin = Clock::now();
            const StepReport report = simulation->step(velocity, time, setup_.dt);
            const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
            if (report.unreached > 0 || report.gave_up != GiveUp::none) {
                throw InvariantError("a vertex did not arrive in step " + std::to_string(step));
            }
            min_[step] = std::min(min_[step], seconds);
            sum += seconds;
        }
        sums_.push_back(sum);
        hash_ = mesh_hash(complex);
    }
    /// The sum of the shortest times of all steps, in seconds.
    [[nodiscard]] double shortest() const { return std::accumulate(min_.begin(), min_.end(), 0.0); }
    [[nodiscard]] std::size_t steps() const { return min_.size(); }
    /// Seconds of each run.
    [[nodiscard]] const std::vector<double>& sums() const { return sums_; }
    [[nodiscard]] std::uint64_t hash() const { return hash_; }

private:
    scenes::Setup setup_;
    Complex<double> complex_;
    Options<double> options_;
    TopologyOptions<double> topology_;
    std::vector<double> min_;
    std::vector<double> sums_;
    std::uint64_t hash_ = 0;
};

void measure(benchmark::State& state, const Comparison& c) {
    Side without(c.scene, c.without);
    Side with(c.scene, c.with);
    for (auto _ : state) {
        for (int round = 0; round < rounds; ++round) {
            (round % 2 == 0 ? without : with).run();
            (round % 2 == 0 ? with : without).run();
        }
        state.SetIterationTime(with.shortest());
    }
    if (c.same_mesh && with.hash() != without.hash()) {
        throw InvariantError("the option changes the mesh");
    }
    std::vector<double> ratios;
    for (std::size_t i = 0; i < with.sums().size(); ++i) {
        ratios.push_back(with.sums()[i] / without.sums()[i]);
    }
    std::sort(ratios.begin(), ratios.end());
    const auto steps = static_cast<double>(with.steps());
    state.counters["ratio"] = with.shortest() / without.shortest();
    state.counters["ratio_low"] = ratios[ratios.size() / 4];
    state.counters["ratio_high"] = ratios[ratios.size() * 3 / 4];
    state.counters["us_per_step"] = with.shortest() * 1e6 / steps;
    state.counters["us_per_step_without"] = without.shortest() * 1e6 / steps;
    state.SetLabel("shortest times of " + std::to_string(rounds) + " alternating runs each");
}

} // namespace

void register_comparison(const Comparison& comparison) {
    add_long_row(comparison.name,
                 [comparison](benchmark::State& state) { measure(state, comparison); });
}

} // namespace dsc::bench
