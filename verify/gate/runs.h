// SPDX-License-Identifier: MIT
// The runs that the checks look at, each made once, several at a time.
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

/// A limit, and what it is of.
struct Held {
    std::shared_ptr<const Check> check;
    Limit limit;
};

/// A [[case]] of a suite: a scene with its parameters, and what it is held to.
struct Case {
    std::string name; ///< of its rows
    scenes::SceneFile file;
    std::string path{}; ///< of the scene file; empty: a scene of the catalogue
    /// In three dimensions: `file` then has its name, keys and parameters, and prepares nothing.
    std::shared_ptr<const scenes::space::Scene> space{};
    scenes::Parameters parameters{};
    std::vector<scenes::Strategy> strategies{}; ///< parallel ones, which are compared
    std::vector<std::uint32_t> threads{};       ///< of these; empty: as each check has them
    int starts = 1; ///< in which library and reference are compared: edges longer by 0.2 % each
    std::vector<Held> held{};
    std::vector<std::string> missing{}; ///< checks that every case of the suite is to have
    std::optional<std::size_t> table{}; ///< its [[case]], if it has one to itself
};

struct Configuration {
    const Case* of = nullptr; ///< outlives it
    scenes::Parameters parameters{};
    scenes::Strategy strategy = scenes::Strategy::sequential;
    std::uint32_t threads = 1;
    /// The first steps alone, in which all threads get a share, whether that pays or not.
    bool is_shared = false;

    /// The same for runs that give the same result.
    [[nodiscard]] std::string key() const;
    /// What `run_scene` takes beside scene and parameters.
    [[nodiscard]] scenes::RunOptions options() const;
};

struct Outcome {
    Configuration configuration{};
    scenes::RunResult result{};
    std::exception_ptr error{}; ///< that the run threw
    double seconds = 0;
    bool is_done = false;
};

/// Begins with the runs at once, in this order; the results do not depend on how many are made at a
/// time. The destructor waits for those under way and leaves out the others.
class Runs {
public:
    Runs(const std::vector<Configuration>& configurations, int jobs);
    ~Runs();
    Runs(const Runs&) = delete;
    Runs& operator=(const Runs&) = delete;

    /// Waits for a run. Throws std::out_of_range for one that was not asked for.
    const Outcome& wait(const Configuration& configuration);
    /// All that are done; nothing may be under way.
    [[nodiscard]] const std::map<std::string, Outcome>& all() const { return outcomes_; }

private:
    void work();

    std::map<std::string, Outcome> outcomes_;
    std::vector<Outcome*> queue_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;
    std::condition_variable done_;
    std::vector<std::jthread> workers_; ///< which the destructor waits for
};

} // namespace dsc::gate
