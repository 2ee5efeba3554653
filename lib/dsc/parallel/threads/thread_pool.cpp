// SPDX-License-Identifier: MIT
#include "dsc/parallel/threads/thread_pool.h"

#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <string_view>

#if defined(__linux__)
#include <sched.h>
#endif

namespace dsc {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t is_open = 1;
constexpr std::uint32_t one_inside = 2;

/// The number of reads of the bell (the wake-up signal) between two reads of the clock: a few
/// microseconds.
constexpr int looks = 64;

// Where threads run. A thread that has just been started is often on the core of the one that
// started it, and stays there for milliseconds, while another core is idle.

#if defined(__linux__)

/// The core that runs the calling thread at this moment; -1 if the system does not support the
/// query.
int current_core() { return sched_getcpu(); }

/// Moves the calling thread off this core: to the `number`th of the others that it is allowed to
/// use, counted in circles. The system may move it again later. Does nothing without another core,
/// or if the system does not support it.
void leave_core(int core, unsigned number) {
    cpu_set_t allowed;
    if (core < 0 || core >= CPU_SETSIZE || sched_getaffinity(0, sizeof allowed, &allowed) != 0) {
        return;
    }
    cpu_set_t others = allowed;
    CPU_CLR(static_cast<unsigned>(core), &others);
    const int count = CPU_COUNT(&others);
    if (count == 0) {
        return;
    }
    unsigned left = number % static_cast<unsigned>(count);
    for (unsigned other = 0; other < CPU_SETSIZE; ++other) {
        if (CPU_ISSET(other, &others) && left-- == 0) {
            cpu_set_t one;
            CPU_ZERO(&one);
            CPU_SET(other, &one);
            if (sched_setaffinity(0, sizeof one, &one) == 0) {
                sched_setaffinity(0, sizeof allowed, &allowed);
            }
            return;
        }
    }
}

/// Allows the calling thread these cores. Does nothing if there are none, or if the system does not
/// support it.
void use_cores(const std::vector<int>& cores) {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    for (const int core : cores) {
        if (core >= 0 && core < CPU_SETSIZE) {
            CPU_SET(static_cast<unsigned>(core), &allowed);
        }
    }
    if (CPU_COUNT(&allowed) > 0) {
        sched_setaffinity(0, sizeof allowed, &allowed);
    }
}

#else

int current_core() { return -1; }
void leave_core(int /*core*/, unsigned /*number*/) {}
void use_cores(const std::vector<int>& /*cores*/) {}

#endif

/// The cores of all places of OpenMP, if it binds threads to places (`OMP_PROC_BIND`): the caller
/// may then be confined to one of them, and a thread that it starts would be too. Empty if not.
std::vector<int> cores_of_openmp() {
    std::vector<int> cores;
    // Tests the variable first, since a query starts OpenMP.
    if (std::getenv("OMP_PROC_BIND") == nullptr || // NOLINT: nobody here sets variables
        omp_get_proc_bind() == omp_proc_bind_false) {
        return cores;
    }
    for (int place = 0; place < omp_get_num_places(); ++place) {
        std::vector<int> some(static_cast<std::size_t>(omp_get_place_num_procs(place)));
        omp_get_place_proc_ids(place, some.data());
        cores.insert(cores.end(), some.begin(), some.end());
    }
    return cores;
}

} // namespace

std::chrono::microseconds default_awake_time() {
    const char* policy = std::getenv("OMP_WAIT_POLICY"); // NOLINT: nobody here sets variables
    const bool is_passive = policy != nullptr && (std::string_view(policy) == "passive" ||
                                                  std::string_view(policy) == "PASSIVE");
    return std::chrono::microseconds(is_passive ? 0 : 2000);
}

/// One thread, and the bell that calls it: on a cache line of its own.
struct alignas(64) ThreadPool::Worker {
    std::atomic<std::uint32_t> bell = 0; ///< rings so far
    std::uint32_t number = 0;            ///< 0 for the first one
    std::thread thread;
};

ThreadPool::ThreadPool(std::chrono::microseconds awake) : awake_(awake) {}

void ThreadPool::start(std::uint32_t threads) {
    callers_core_.store(current_core(), std::memory_order_relaxed);
    if (threads <= size() || is_refused_) {
        return;
    }
    const std::vector<int> cores = cores_of_openmp();
    done_.busy_s.resize(std::max<std::size_t>(threads, done_.busy_s.size()));
    for (std::uint32_t thread = size(); thread < threads; ++thread) {
        workers_.push_back(std::make_unique<Worker>());
        Worker& worker = *workers_.back();
        worker.number = thread - 1;
        try {
            worker.thread = std::thread([this, thread, &worker, cores] {
                use_cores(cores);
                serve(thread, worker);
            });
        } catch (const std::exception&) {
            workers_.pop_back();
            is_refused_ = true; // the other threads do its work
            break;
        }
    }
}

ThreadPool::~ThreadPool() {
    has_ended_.store(true, std::memory_order_release);
    ring(size());
    for (const auto& worker : workers_) {
        worker->thread.join();
    }
}

void ThreadPool::wake(std::uint32_t threads) {
    callers_core_.store(current_core(), std::memory_order_relaxed);
    ring(threads);
}

void ThreadPool::ring(std::uint32_t threads) {
    for (std::uint32_t i = 0; i + 1 < std::min(threads, size()); ++i) {
        workers_[i]->bell.fetch_add(1, std::memory_order_release);
        workers_[i]->bell.notify_one();
    }
}

void ThreadPool::run(std::uint32_t threads, const std::function<void(std::uint32_t)>& work) {
    if (threads <= 1 || workers_.empty()) {
        work(0);
        return;
    }
    const Clock::time_point begin = Clock::now();
    callers_core_.store(current_core(), std::memory_order_relaxed); // it may have been moved
    work_ = &work;
    wanted_ = threads;
    ++section_;
    door_.store(is_open, std::memory_order_release);
    ring(threads);
    work(0);
    door_.fetch_and(~is_open, std::memory_order_acq_rel);
    for (WaitingTurns turns; door_.load(std::memory_order_acquire) != 0;) {
        turns.wait(); // waits for workers that are still inside
    }
    done_.sections_s += std::chrono::duration<double>(Clock::now() - begin).count();
}

void ThreadPool::serve(std::uint32_t thread, Worker& worker) {
    std::uint32_t heard = 0;
    std::uint64_t served = 0; // the last section that it worked in
    while (true) {
        await_ring(worker, heard);
        heard = worker.bell.load(std::memory_order_acquire);
        if (has_ended_.load(std::memory_order_acquire)) {
            return;
        }
        // A late worker finds the door (the section's entry) closed, or already open for the next
        // section.
        std::uint32_t door = door_.load(std::memory_order_acquire);
        while ((door & is_open) != 0) {
            if (door_.compare_exchange_weak(door, door + one_inside, std::memory_order_acq_rel,
                                            std::memory_order_acquire)) {
                // A signal that arrives while the worker is inside, or a little later, may be for
                // this section.
                if (thread < wanted_ && served != section_) {
                    served = section_;
                    (*work_)(thread);
                }
                door_.fetch_sub(one_inside, std::memory_order_release);
                break;
            }
        }
    }
}

// Moves a worker off the caller's core, where it would delay the caller.
void ThreadPool::stay_apart(const Worker& worker) const {
    const int core = callers_core_.load(std::memory_order_relaxed);
    if (core >= 0 && core == current_core()) {
        leave_core(core, worker.number);
    }
}

void ThreadPool::await_ring(const Worker& worker, std::uint32_t heard) const {
    if (awake_.count() > 0) {
        const Clock::time_point begin = Clock::now();
        do {
            stay_apart(worker);
            for (int look = 0; look < looks; ++look) {
                if (worker.bell.load(std::memory_order_relaxed) != heard) {
                    return;
                }
                pause_briefly();
            }
        } while (Clock::now() - begin < awake_);
    }
    worker.bell.wait(heard, std::memory_order_acquire);
}

} // namespace dsc
