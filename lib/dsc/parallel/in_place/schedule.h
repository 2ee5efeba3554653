// SPDX-License-Identifier: MIT
// Runs tasks on threads: static and dynamic assignment (thesis, section 6.2). A task of a later
// colour starts as soon as the tasks that it waits for are done, by flags: there is no barrier
// between the colours. The result of a task never depends on the thread that runs it.
#pragma once

#include "dsc/parallel/parallel.h"
#include "dsc/parallel/submesh_view.h"
#include "dsc/parallel/threads/thread_pool.h"

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <vector>

namespace dsc {

/// Runs the tasks of a graph, any number of times.
class Schedule {
public:
    TaskGraph tasks; ///< the tasks and their dependencies; must not change during a run

    /// Calls `run(task)` once for each task, on at most this many threads of the pool. If a task
    /// throws, those that wait for it do not start, and all others do: the set of tasks that run
    /// does not depend on threads. The exception of the first task that threw is rethrown when all
    /// have ended. No allocation if the graph has not grown.
    void run(ThreadPool& pool, std::uint32_t threads, Assignment assignment,
             const std::function<void(std::size_t task)>& run);

private:
    [[nodiscard]] bool is_ready(std::size_t task) const;
    [[nodiscard]] bool is_last_one(std::size_t task, std::uint32_t threads) const;
    [[nodiscard]] bool follows_failure(std::size_t task) const;
    bool claim(std::size_t task);
    /// Returns for how many seconds the thread was busy with tasks.
    double work(std::uint32_t thread, std::uint32_t threads, Assignment assignment,
                const std::function<void(std::size_t)>& run);
    void run_one(std::size_t task, const std::function<void(std::size_t)>& run);

    std::unique_ptr<std::atomic<std::uint8_t>[]> states_;
    std::vector<std::exception_ptr> failures_; // by task
    std::atomic<bool> has_failed_ = false;
};

} // namespace dsc
