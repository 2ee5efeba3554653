// SPDX-License-Identifier: MIT
// The times of a step, task by task: for the breakdown, for the picture of submeshes by their work,
// and for the model of more threads than the machine has.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/parallel/partition/partition.h"

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

namespace dsc {

/// Tasks and their dependences, in an order in which each comes after those it waits for.
class TaskGraph {
public:
    /// Forgets all tasks.
    void clear();
    /// Adds one colour of this many tasks; returns the number of the first.
    std::size_t add_colour(std::size_t tasks);
    /// `task` waits for `earlier`, which has a smaller number. Call in the order of `task`.
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

/// The times of a sub-step, in seconds of a steady clock. On one thread of an idle machine these
/// are the times of the tasks themselves.
struct SubStepProfile {
    // Serial parts.
    double set_up = 0;    ///< cuts, lists and ids, before anything runs
    double hand_over = 0; ///< vertices that left their submesh
    double clean_up = 0;  ///< work deferred by all colours, and updating the lists
    // By task.
    std::vector<double>
        targets;              ///< remeshing, velocities and targets, by submesh of the first colour
    std::vector<double> move; ///< movement and mesh update: all submeshes of all colours
    // Wall time of the two parallel sections.
    double targets_wall = 0; ///< remeshing, velocities and targets
    double move_wall = 0;    ///< movement and mesh update
};

/// The work of threads since the executor was made, in seconds of a steady clock.
struct ThreadWork {
    double sections_s = 0;        ///< wall time of the parallel sections
    std::vector<double> busy_s{}; ///< by thread: time in tasks of these sections, without waiting

    /// The busy time of all threads minus the wall time of the sections: the busy time of a run is
    /// its wall time plus this. Negative if threads mostly waited.
    [[nodiscard]] double beyond_one() const {
        return std::accumulate(busy_s.begin(), busy_s.end(), -sections_s);
    }
};

/// The state of an executor in submeshes. Valid until the next step.
struct SubmeshView {
    const Partition& partition;              ///< in force
    const TaskGraph& tasks;                  ///< task i is that of `SubStepProfile::move`
    std::span<const SubStepProfile> profile; ///< of the last step, if `Parallel::profile` is set
    std::uint32_t threads_used;              ///< by the last step
    const ThreadWork& work;                  ///< of all steps
};

/// The view of an executor that `make_executor` made; empty for one without submeshes of this kind.
/// O(1).
template <class Real>
[[nodiscard]] std::optional<SubmeshView> submeshes_in(const Executor<Real>& executor);

} // namespace dsc
