// SPDX-License-Identifier: MIT
#include "dsc/parallel/in_place/schedule.h"

#include <omp.h>

#include <algorithm>
#include <exception>
#include <thread>

namespace dsc {

namespace {

enum State : std::uint8_t { waiting, claimed, done };

/// Turns of waiting before the core is given to another thread: a task takes tens of microseconds.
constexpr int turns_before_yield = 2000;

void pause_briefly() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

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
        return states_[earlier].load(std::memory_order_acquire) == done;
    });
}

void Schedule::run_one(std::size_t task, const std::function<void(std::size_t)>& run) {
    if (!has_failed_.load(std::memory_order_relaxed)) {
        try {
            run(task);
        } catch (...) {
            failures_[task] = std::current_exception();
            has_failed_.store(true, std::memory_order_relaxed);
        }
    }
    states_[task].store(done, std::memory_order_release);
}

void Schedule::work(std::uint32_t thread, std::uint32_t threads, Assignment assignment,
                    const std::function<void(std::size_t)>& run) {
    const auto is_mine = [&](std::size_t task) { return tasks.home_of(task, threads) == thread; };
    const auto claim = [&](std::size_t task) {
        std::uint8_t expected = waiting;
        return states_[task].compare_exchange_strong(expected, claimed, std::memory_order_acq_rel);
    };
    int turns = 0;
    while (true) {
        bool is_any_left = false;
        bool has_run = false;
        // First this thread's own tasks in order; then, from the end, those that others have not
        // begun.
        for (std::size_t task = 0; task < tasks.size(); ++task) {
            if (is_mine(task) && states_[task].load(std::memory_order_relaxed) == waiting) {
                if (is_ready(task) && claim(task)) {
                    run_one(task, run);
                    has_run = true;
                } else {
                    is_any_left = true;
                }
            }
        }
        if (assignment == Assignment::queue) {
            for (std::size_t i = tasks.size(); i > 0 && !has_run; --i) {
                const std::size_t task = i - 1;
                if (states_[task].load(std::memory_order_relaxed) == waiting) {
                    is_any_left = true;
                    if (is_ready(task) && claim(task)) {
                        run_one(task, run);
                        has_run = true;
                    }
                }
            }
        }
        if (!is_any_left && !has_run) {
            return;
        }
        turns = has_run ? 0 : turns + 1;
        if (turns > turns_before_yield) {
            std::this_thread::yield();
        } else {
            pause_briefly();
        }
    }
}

void Schedule::start_threads(std::uint32_t threads) {
    if (threads <= 1) {
        return;
    }
    std::atomic<std::uint32_t> started = 0; // without an effect, a section might be optimized away
#pragma omp parallel num_threads(static_cast <int>(threads))
    started.fetch_add(1, std::memory_order_relaxed);
}

void Schedule::run(std::uint32_t threads, Assignment assignment,
                   const std::function<void(std::size_t)>& run) {
    if (failures_.size() < tasks.size()) {
        states_ = std::make_unique<std::atomic<std::uint8_t>[]>(tasks.size());
        failures_.assign(tasks.size(), nullptr);
    }
    for (std::size_t task = 0; task < tasks.size(); ++task) {
        states_[task].store(waiting, std::memory_order_relaxed);
    }
    if (threads <= 1) {
        for (std::size_t task = 0; task < tasks.size(); ++task) {
            run_one(task, run);
        }
    } else {
#pragma omp parallel num_threads(static_cast <int>(threads))
        work(static_cast<std::uint32_t>(omp_get_thread_num()),
             static_cast<std::uint32_t>(omp_get_num_threads()), assignment, run);
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
