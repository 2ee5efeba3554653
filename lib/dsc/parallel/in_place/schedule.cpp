// SPDX-License-Identifier: MIT
#include "dsc/parallel/in_place/schedule.h"
#include "dsc/base/timer.h"
#include "dsc/parallel/submesh_view.h"

#include <algorithm>

namespace dsc {

namespace {

enum State : std::uint8_t {
    waiting,
    claimed,
    done,
    failed, ///< the task has thrown, or one that it waits for
};

} // namespace

void TaskGraph::clear() {
    shares_.clear();
    first_predecessor_.clear();
    predecessors_.clear();
}

std::size_t TaskGraph::add_colour(std::size_t tasks) {
    const std::size_t first = shares_.size();
    for (std::size_t i = 0; i < tasks; ++i) {
        shares_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(tasks)});
        first_predecessor_.push_back(static_cast<std::uint32_t>(predecessors_.size()));
    }
    return first;
}

void TaskGraph::wait_for(std::size_t task, std::size_t earlier) {
    predecessors_.push_back(static_cast<std::uint32_t>(earlier));
    for (std::size_t later = task + 1; later < first_predecessor_.size(); ++later) {
        first_predecessor_[later] = static_cast<std::uint32_t>(predecessors_.size());
    }
}

std::span<const std::uint32_t> TaskGraph::predecessors(std::size_t task) const {
    const std::size_t begin = first_predecessor_[task];
    const std::size_t end =
        task + 1 < first_predecessor_.size() ? first_predecessor_[task + 1] : predecessors_.size();
    return {predecessors_.data() + begin, end - begin};
}

bool Schedule::is_ready(std::size_t task) const {
    return std::ranges::all_of(tasks.predecessors(task), [this](std::uint32_t earlier) {
        return states_[earlier].load(std::memory_order_acquire) >= done;
    });
}

bool Schedule::follows_failure(std::size_t task) const {
    return has_failed_.load(std::memory_order_relaxed) &&
           std::ranges::any_of(tasks.predecessors(task), [this](std::uint32_t earlier) {
               return states_[earlier].load(std::memory_order_relaxed) == failed;
           });
}

bool Schedule::claim(std::size_t task) {
    std::uint8_t expected = waiting;
    return states_[task].compare_exchange_strong(expected, claimed, std::memory_order_acq_rel);
}

void Schedule::run_one(std::size_t task, const std::function<void(std::size_t)>& run) {
    State outcome = follows_failure(task) ? failed : done;
    if (outcome == done) {
        try {
            run(task);
        } catch (...) {
            failures_[task] = std::current_exception();
            has_failed_.store(true, std::memory_order_relaxed);
            outcome = failed;
        }
    }
    states_[task].store(outcome, std::memory_order_release);
}

// Whether the task is the last one of a thread that is busy. Fetching its part of the mesh from
// that thread's core would take longer than waiting for the thread. O(tasks).
bool Schedule::is_last_one(std::size_t task, std::uint32_t threads) const {
    bool has_begun = false;
    for (std::size_t other = 0; other < tasks.size(); ++other) {
        if (other != task && tasks.home_of(other, threads) == tasks.home_of(task, threads)) {
            if (states_[other].load(std::memory_order_relaxed) == waiting) {
                return false;
            }
            has_begun = true;
        }
    }
    return has_begun;
}

double Schedule::work(std::uint32_t thread, std::uint32_t threads, Assignment assignment,
                      const std::function<void(std::size_t)>& run) {
    const bool takes_over = assignment == Assignment::queue;
    WaitingTurns turns;
    Timer round; // the clock is read once for each round, not for each task
    double busy_s = 0;
    double idle_s = 0; // since the last task
    std::uint32_t done_here = 0;
    while (true) {
        bool is_any_left = false; // tasks that this thread must run or wait for
        bool has_run = false;
        const auto attempt = [&](std::size_t task) {
            if (!claim(task)) {
                return false;
            }
            run_one(task, run);
            ++done_here;
            return has_run = true;
        };
        // First this thread's own tasks in order; then, from the end, the tasks of others: the last
        // one of a thread only if this thread has been idle for as long as a task takes.
        for (std::size_t task = 0; task < tasks.size(); ++task) {
            if (states_[task].load(std::memory_order_relaxed) != waiting) {
                continue;
            }
            // The section ends with the caller's part, so the caller waits for the others.
            const bool is_own = tasks.home_of(task, threads) == thread;
            is_any_left |= is_own ? !(is_ready(task) && attempt(task)) : takes_over || thread == 0;
        }
        const bool is_late = idle_s * done_here >= busy_s;
        for (std::size_t i = tasks.size(); takes_over && i > 0 && !has_run; --i) {
            if (states_[i - 1].load(std::memory_order_relaxed) == waiting && is_ready(i - 1) &&
                (is_late || !is_last_one(i - 1, threads))) {
                attempt(i - 1);
            }
        }
        if (!is_any_left && !has_run) {
            return busy_s;
        }
        const double round_s = round.lap();
        if (has_run) {
            busy_s += round_s;
            idle_s = 0;
            turns.start_over();
        } else {
            idle_s += round_s;
            turns.wait();
        }
    }
}

void Schedule::run(ThreadPool& pool, std::uint32_t threads, Assignment assignment,
                   const std::function<void(std::size_t)>& run) {
    if (failures_.size() < tasks.size()) {
        states_ = std::make_unique<std::atomic<std::uint8_t>[]>(tasks.size());
        failures_.assign(tasks.size(), nullptr);
    }
    for (std::size_t task = 0; task < tasks.size(); ++task) {
        states_[task].store(waiting, std::memory_order_relaxed);
    }
    threads = std::min(threads, pool.size());
    if (threads <= 1) {
        Timer section;
        for (std::size_t task = 0; task < tasks.size(); ++task) {
            run_one(task, run);
        }
        pool.add_section_alone(section.lap());
    } else {
        const auto share = [&](std::uint32_t thread) {
            pool.add_busy(thread, work(thread, threads, assignment, run));
        };
        pool.run(threads, std::cref(share));
    }
    if (has_failed_.exchange(false)) {
        const auto first =
            std::ranges::find_if(failures_, [](const auto& f) { return f != nullptr; });
        const std::exception_ptr failure = *first;
        std::ranges::fill(failures_, nullptr);
        std::rethrow_exception(failure);
    }
}

} // namespace dsc
