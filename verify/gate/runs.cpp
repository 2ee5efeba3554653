// SPDX-License-Identifier: MIT
#include "runs.h"

#include <chrono>

namespace dsc::gate {

namespace {

constexpr int shared_steps = 40; ///< enough to show whether threads change the result

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

Runs::~Runs() {
    {
        const std::lock_guard lock(mutex_);
        next_ = queue_.size();
    }
    for (std::thread& worker : workers_) {
        worker.join();
    }
}

void Runs::work() {
    for (;;) {
        Outcome* outcome = nullptr;
        {
            const std::lock_guard lock(mutex_);
            if (next_ == queue_.size()) {
                return;
            }
            outcome = queue_[next_++];
        }
        const Configuration& what = outcome->configuration;
        const auto start = std::chrono::steady_clock::now();
        scenes::RunResult result;
        std::exception_ptr error;
        try {
            result = scenes::run_scene(what.of->file.scene, what.parameters, what.options());
        } catch (...) {
            error = std::current_exception();
        }
        const std::lock_guard lock(mutex_);
        outcome->result = std::move(result);
        outcome->error = error;
        outcome->seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        outcome->is_done = true;
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
