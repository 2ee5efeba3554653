// SPDX-License-Identifier: MIT
// Parallel DSC in one line: `Simulation simulation(complex, options, Parallel{.threads = 2})`. And
// where the time of a step went, task by task: for the breakdown, for the picture of submeshes by
// their work, and for the model of more threads than the machine has.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/base/types.h"
#include "dsc/parallel/partition/partition.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace dsc {

struct Division;
extern const Division cells_division; ///< submeshes that follow the interface

/// Which thread runs which task.
enum class Assignment : std::uint8_t {
    fixed, ///< each thread always has the same share of each colour: static assignment
    queue, ///< the same, but an idle thread takes over tasks that nobody has begun: the last task
           ///< of another thread only if that thread is late
};

inline constexpr std::array assignment_names{
    Named{Assignment::fixed, "fixed"},
    Named{Assignment::queue, "queue"},
};

[[nodiscard]] constexpr std::string_view to_string(Assignment assignment) {
    return name_in(assignment_names, assignment);
}

/// The result depends on the division and the number of submeshes, and on nothing else here.
struct Parallel {
    /// 1 to 1024; fewer are used where there is too little to do, or where that takes no longer.
    std::uint32_t threads = 1;
    const Division* division = &cells_division; ///< how the mesh is divided; outlives the executor
    std::uint32_t submeshes = 0;                ///< 0: the division's own choice
    bool always_all_threads = false; ///< also if there is too little to do for them, or no gain
    Assignment assignment = Assignment::queue; ///< which thread runs which submesh
    bool profile = false;                      ///< measure times: see `SubmeshView`
};

/// Makes an executor for either precision.
template <class Real>
using MakeExecutor = std::unique_ptr<Executor<Real>> (*)(Complex<Real>& complex,
                                                         const Options<Real>& options,
                                                         const Parallel& parallel,
                                                         Algorithm<Real> algorithm);

/// How the mesh is divided into submeshes: in the library's way, in one of a module, or in one of
/// the application's own.
struct Division {
    std::string_view name;          ///< on command lines and in files
    std::string_view description;   ///< one sentence, for help texts
    std::uint32_t submeshes;        ///< if no number is asked for; 0: chosen during the run
    MakeExecutor<double> in_double; ///< makes its executor
    MakeExecutor<float> in_float;   ///< makes its executor
};

/// The number of submeshes that results: the number asked for, or the division's default; 0: chosen
/// during the run.
[[nodiscard]] std::uint32_t submeshes_of(const Parallel& parallel);

/// The executor for these options, for an algorithm of your own. Throws InputError if the options
/// make no sense together, or while a simulation of the complex lives.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              Algorithm<Real> algorithm = default_algorithm<Real>());
/// The same with a partitioner of your own, which takes the place of `parallel.division`.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              std::type_identity_t<std::unique_ptr<Partitioner<Real>>> partitioner,
              Algorithm<Real> algorithm = default_algorithm<Real>());

// --- what can be seen of a step ------------------------------------------------------------------

/// Tasks and their dependences, in an order in which each comes after those it waits for.
class TaskGraph {
public:
    /// Forgets all tasks.
    void clear();
    /// Adds one colour of so many tasks; returns the number of the first.
    std::size_t add_colour(std::size_t tasks);
    /// `task` waits for `earlier`, which has a smaller number. To be called in the order of `task`.
    void wait_for(std::size_t task, std::size_t earlier);

    /// The number of tasks.
    [[nodiscard]] std::size_t size() const { return shares_.size(); }
    /// The tasks that this one waits for.
    [[nodiscard]] std::span<const std::uint32_t> predecessors(std::size_t task) const;
    /// The thread, out of `threads`, to which this task is assigned first.
    [[nodiscard]] std::uint32_t home_of(std::size_t task, std::uint32_t threads) const {
        return static_cast<std::uint32_t>(static_cast<std::uint64_t>(shares_[task].rank) * threads /
                                          shares_[task].of);
    }

private:
    struct Share { // which of how many tasks of its colour
        std::uint32_t rank;
        std::uint32_t of;
    };
    std::vector<Share> shares_;
    std::vector<std::uint32_t> first_predecessor_; // into predecessors_
    std::vector<std::uint32_t> predecessors_;
};

/// The times of a sub-step, in seconds of a steady clock. On one thread of an idle machine that is
/// the time of the task itself.
struct SubStepProfile {
    // Serial parts.
    double set_up = 0;    ///< cuts, lists and ids, before anything runs
    double hand_over = 0; ///< vertices that left their submesh
    double clean_up = 0;  ///< what all colours left, and updating the lists
    // By task.
    std::vector<double>
        targets;              ///< remeshing, velocities and targets, by submesh of the first colour
    std::vector<double> move; ///< movement and mesh update: all submeshes of all colours
    // Wall time of the two parallel sections.
    double targets_wall = 0; ///< remeshing, velocities and targets
    double move_wall = 0;    ///< movement and mesh update
};

/// What threads have done since the executor was made, in seconds of a steady clock.
struct ThreadWork {
    double sections_s = 0;        ///< wall time of the parallel sections
    std::vector<double> busy_s{}; ///< by thread, in them: with a task, rather than waiting for one

    /// How much longer all threads together were busy than a caller that never waits: the busy time
    /// of a run is its wall time and this. Negative if threads mostly waited.
    [[nodiscard]] double beyond_one() const {
        return std::accumulate(busy_s.begin(), busy_s.end(), -sections_s);
    }
};

/// What an executor in submeshes shows. All of it changes with the next step.
struct SubmeshView {
    const Partition& partition;              ///< in force
    const TaskGraph& tasks;                  ///< task i is that of `SubStepProfile::move`
    std::span<const SubStepProfile> profile; ///< of the last step, if `Parallel::profile` is set
    std::uint32_t threads_used;              ///< by the last step
    const ThreadWork& work;                  ///< of all steps
};

/// Of an executor that `make_executor` has made; nothing for one that has no submeshes of this
/// kind. O(1).
template <class Real>
[[nodiscard]] std::optional<SubmeshView> submeshes_in(const Executor<Real>& executor);

/// Seconds from call to call. Switched off, it reads no clock and returns 0.
class Timer {
public:
    /// Starts, unless it is switched off.
    explicit Timer(bool on = true) : on_(on) {
        if (on_) {
            last_ = std::chrono::steady_clock::now();
        }
    }
    /// Seconds since the last call, or since construction.
    double lap() {
        if (!on_) {
            return 0;
        }
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

private:
    bool on_;
    std::chrono::steady_clock::time_point last_;
};

} // namespace dsc
