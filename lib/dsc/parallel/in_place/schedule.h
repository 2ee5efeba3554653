// SPDX-License-Identifier: MIT
// Runs tasks on threads: static and dynamic assignment (thesis, section 6.2). A task of a later
// colour starts as soon as the tasks that it waits for are done, by flags: there is no barrier
// between the colours. The result of a task never depends on the thread that runs it.
#pragma once

#include "dsc/base/enum_table.h"
#include "dsc/base/function_ref.h"
#include "dsc/parallel/threads/thread_pool.h"

#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <vector>

namespace dsc {

/// Which thread runs which task.
enum class Assignment : std::uint8_t {
    fixed, ///< each thread always has the same share of each colour: static assignment
    queue, ///< the same, but an idle thread takes over tasks that nobody has begun
};

inline constexpr std::array assignment_names{
    Named{Assignment::fixed, "fixed"},
    Named{Assignment::queue, "queue"},
};

[[nodiscard]] constexpr std::string_view to_string(Assignment assignment) {
    return name_in(assignment_names, assignment);
}

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

/// Runs the tasks of a graph, any number of times.
class Schedule {
public:
    TaskGraph tasks; ///< what there is to run; not to be changed during a run

    /// Calls `run(task)` once for each, on so many threads of the pool (fewer if it has fewer).
    /// Where one has thrown, the tasks that wait for it do not begin, the others do: so what has
    /// been done does not depend on threads. The exception of the first of them is rethrown when
    /// all have ended. No allocation if the graph has not grown.
    void run(ThreadPool& pool, std::uint32_t threads, Assignment assignment,
             FunctionRef<void(std::size_t task)> run);

private:
    [[nodiscard]] bool is_ready(std::size_t task) const;
    [[nodiscard]] bool follows_failure(std::size_t task) const;
    bool claim(std::size_t task);
    void work(std::uint32_t thread, std::uint32_t threads, Assignment assignment,
              FunctionRef<void(std::size_t)> run);
    void run_one(std::size_t task, FunctionRef<void(std::size_t)> run);

    std::unique_ptr<std::atomic<std::uint8_t>[]> states_;
    std::vector<std::exception_ptr> failures_; // by task
    std::atomic<bool> has_failed_ = false;
};

} // namespace dsc
