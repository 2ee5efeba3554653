// SPDX-License-Identifier: MIT
// The runs that the checks need, each made once, several at a time.
#pragma once

#include "limits.h"

#include "scenes/file/scene_file.h"
#include "scenes/run/run.h"
#include "scenes/space/scene.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace dsc::gate {

/// A limit and its check.
struct Held {
    std::shared_ptr<const Check> check;
    Limit limit;
};

/// A [[case]] of a suite: a scene with its parameters and limits.
struct Case {
    std::string name; ///< of its rows
    scenes::SceneFile file;
    std::string path{}; ///< of the scene file; empty: a scene of the catalogue
    /// Set for a scene in three dimensions; `file` then has only its name, keys and parameters.
    std::shared_ptr<const scenes::space::Scene> space{};
    scenes::Parameters parameters{};
    std::vector<scenes::Strategy> strategies{}; ///< parallel ones, which are compared
    std::vector<std::uint32_t> threads{};       ///< numbers of threads; empty: chosen by each check
    int starts = 1; ///< for comparing library and reference: edge lengths differ by 0.2 % each
    std::vector<Held> held{};
    std::vector<std::string> missing{}; ///< required checks of the suite that the case lacks
    std::optional<std::size_t> table{}; ///< its [[case]], if no other case shares it
};

struct Configuration {
    const Case* of = nullptr; ///< must outlive this
    scenes::Parameters parameters{};
    scenes::Strategy strategy = scenes::Strategy::sequential;
    std::uint32_t threads = 1;
    /// Only the first steps, in which all threads are used even if it is slower.
    bool is_shared = false;

    /// Equal keys mean equal results.
    [[nodiscard]] std::string key() const;
    /// The options of `run_scene`.
    [[nodiscard]] scenes::RunOptions options() const;
};

struct Outcome {
    Configuration configuration{};
    scenes::RunResult result{};
    std::exception_ptr error{}; ///< exception of the run
    double seconds = 0;
    bool is_done = false;
};

/// Starts the runs at once, in this order; the results do not depend on the number of parallel
/// runs. The destructor waits for those that have started and does not start the others.
class Runs {
public:
    Runs(const std::vector<Configuration>& configurations, int jobs);
    ~Runs();
    Runs(const Runs&) = delete;
    Runs& operator=(const Runs&) = delete;

    /// Waits for a run. Throws std::out_of_range for a run that is not in the list.
    const Outcome& wait(const Configuration& configuration);
    /// All finished runs; none may be running.
    [[nodiscard]] const std::map<std::string, Outcome>& all() const { return outcomes_; }

private:
    void work();

    std::map<std::string, Outcome> outcomes_;
    std::vector<Outcome*> queue_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;
    std::condition_variable done_;
    std::vector<std::jthread> workers_; ///< joined by the destructor
};

} // namespace dsc::gate
