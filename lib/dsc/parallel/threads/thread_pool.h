// SPDX-License-Identifier: MIT
// Threads that are ready when a parallel section begins. A section of a step lasts tens of
// microseconds, and waking a thread takes as long; OpenMP's threads fall asleep while the
// application works between two steps. So workers wait awake for a time that can be set, and a
// section never waits for a late worker: it ends when all its work is done, by any of the threads.
#pragma once

#include "dsc/parallel/parallel.h"
#include "dsc/parallel/submesh_view.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace dsc {

/// Tells the core that this is a loop that waits.
inline void pause_briefly() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

/// Pauses of a waiting loop: brief ones at first, because a task takes tens of microseconds; later
/// the core is yielded to other threads.
class WaitingTurns {
public:
    /// One turn of the loop. O(1).
    void wait() {
        constexpr int turns_before_yield = 2000;
        if (turns_ < turns_before_yield) {
            ++turns_;
            pause_briefly();
        } else {
            std::this_thread::yield();
        }
    }
    /// The next turns are brief again.
    void start_over() { turns_ = 0; }

private:
    int turns_ = 0;
};

/// How long workers wait awake for the next section before they sleep, by default: 2 milliseconds;
/// 0 if the environment variable OMP_WAIT_POLICY is `passive`, as on machines whose cores are
/// shared.
[[nodiscard]] std::chrono::microseconds default_awake_time();

/// The caller and its workers. Sections of one pool are run one after the other, by one caller.
class ThreadPool : public Unmovable {
public:
    /// `awake`: how long a worker waits awake for the next section before it sleeps.
    explicit ThreadPool(std::chrono::microseconds awake = default_awake_time());
    /// Ends the workers, which takes no longer than to wake them.
    ~ThreadPool();

    /// Starts workers until there are this many threads, including the caller, or the system
    /// provides no more. A worker that was started stays.
    void start(std::uint32_t threads);
    /// The number of threads: the caller and the workers.
    [[nodiscard]] std::uint32_t size() const {
        return static_cast<std::uint32_t>(workers_.size()) + 1;
    }

    /// The work of all threads in sections. Must not be called in a section.
    [[nodiscard]] const ThreadWork& work_so_far() const { return done_; }
    /// Adds to the busy time of the calling thread, within a section.
    void add_busy(std::uint32_t thread, double seconds) { done_.busy_s[thread] += seconds; }
    /// Adds a section that the caller ran alone.
    void add_section_alone(double seconds) {
        done_.sections_s += seconds;
        add_busy(0, seconds);
    }

    /// Wakes sleeping workers because a section for this many threads follows soon. Does not wait.
    void wake(std::uint32_t threads);

    /// Calls `work(thread)`, with 0 on the caller and with 1, 2, ... on those workers that arrive
    /// before the caller's own call has returned. Returns when all of these calls have returned. So
    /// either any thread must be able to do all of the work, or the caller's call must wait for the
    /// others. `work` must not throw. No allocation; pass functions by `std::cref`, so that the
    /// std::function does not allocate either.
    void run(std::uint32_t threads, const std::function<void(std::uint32_t thread)>& work);

private:
    struct Worker;

    void serve(std::uint32_t thread, Worker& worker);
    void ring(std::uint32_t threads);
    void await_ring(const Worker& worker, std::uint32_t heard) const;
    void stay_apart(const Worker& worker) const;

    std::chrono::microseconds awake_;
    std::vector<std::unique_ptr<Worker>> workers_;
    bool is_refused_ = false; ///< the system grants no more
    ThreadWork done_{.busy_s = {0.0}};
    std::atomic<bool> has_ended_ = false;
    std::atomic<int> callers_core_ = -1; ///< at its last call of `start`, `wake` or `run`
    // The section: written while the door is closed and nobody is inside.
    const std::function<void(std::uint32_t)>* work_ = nullptr;
    std::uint32_t wanted_ = 0;
    std::uint64_t section_ = 0;
    /// The lowest bit: the section is open to workers; above it: the number of workers inside.
    alignas(64) std::atomic<std::uint32_t> door_ = 0;
};

} // namespace dsc
