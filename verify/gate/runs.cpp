// SPDX-License-Identifier: MIT
#include "runs.h"

#include "scenes/run/clock.h"
#include "scenes/space/run.h"

namespace dsc::gate {

namespace {

constexpr int shared_steps = 40; ///< enough to show whether threads change the result

// Runs a scene in three dimensions; the figures have their names in result files.
scenes::RunResult run_in_space(const Configuration& what) {
    const scenes::space::RunResult run =
        scenes::space::run_scene(*what.of->space, what.parameters, {});
    scenes::RunResult result;
    result.steps = run.steps;
    result.inverted = run.inverted + (run.problem.empty() ? 0 : 1);
    result.unreached = run.sum.unreached;
    result.gave_up = run.sum.gave_up == dsc3::GiveUp::none ? "" : "too many sub-steps";
    for (const auto& [name, value] : scenes::space::figures(run)) {
        result.last.push_back({name, value});
    }
    return result;
}

} // namespace

std::string Configuration::key() const {
    return of->path + '/' + of->file.scene.name + scenes::text_of(parameters) + '/' +
           scenes::to_string(strategy) + '/' + std::to_string(threads) +
           (is_shared ? "/shared" : "");
}

scenes::RunOptions Configuration::options() const {
    scenes::RunOptions options;
    options.strategy = strategy;
    options.submeshing.threads = threads;
    options.submeshing.always_all_threads = is_shared;
    options.stop_after = is_shared ? shared_steps : 0;
    options.measure_shape = !is_shared;
    return options;
}

Runs::Runs(const std::vector<Configuration>& configurations, int jobs) {
    for (const Configuration& one : configurations) {
        const auto [place, is_new] = outcomes_.try_emplace(one.key());
        if (is_new) {
            place->second.configuration = one;
            queue_.push_back(&place->second);
        }
    }
    for (int i = 0; i < jobs; ++i) {
        workers_.emplace_back([this] { work(); });
    }
}

Runs::~Runs() { next_ = queue_.size(); }

void Runs::work() {
    for (std::size_t i = next_++; i < queue_.size(); i = next_++) {
        Outcome outcome{.configuration = queue_[i]->configuration};
        const Configuration& what = outcome.configuration;
        const scenes::Stopwatch watch;
        try {
            outcome.result = what.of->space ? run_in_space(what)
                                            : scenes::run_scene(what.of->file.scene,
                                                                what.parameters, what.options());
        } catch (...) {
            outcome.error = std::current_exception();
        }
        outcome.seconds = watch.wall();
        outcome.is_done = true;
        const std::lock_guard lock(mutex_);
        *queue_[i] = std::move(outcome);
        done_.notify_all();
    }
}

const Outcome& Runs::wait(const Configuration& configuration) {
    const Outcome& outcome = outcomes_.at(configuration.key());
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return outcome.is_done; });
    return outcome;
}

} // namespace dsc::gate
