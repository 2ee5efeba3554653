// SPDX-License-Identifier: MIT
// Workers join a section or come too late for it, awake or asleep; and the number of threads
// follows from the measured duration of steps.
#include "dsc/parallel/threads/thread_choice.h"
#include "dsc/parallel/threads/thread_pool.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#include <unistd.h>
#endif

namespace dsc::thread_pool_test {
namespace {

using std::chrono::microseconds;

// Each section writes plain numbers that the next one reads: a race for the thread sanitizer if a
// section does not order the two.
void expect_sections(ThreadPool& pool, int sections, microseconds between) {
    std::vector<int> shares(64, 0);
    for (int section = 1; section <= sections; ++section) {
        std::array<std::atomic<int>, 8> calls{};
        std::atomic<std::size_t> next = 0;
        const std::uint32_t threads = 1 + static_cast<std::uint32_t>(section) % 4;
        pool.run(threads, [&](std::uint32_t thread) {
            ASSERT_LT(thread, threads);
            ++calls[thread];
            for (std::size_t i = next++; i < shares.size(); i = next++) {
                ASSERT_EQ(shares[i], section - 1);
                shares[i] = section;
            }
        });
        for (std::size_t thread = 0; thread < calls.size(); ++thread) {
            const int largest = thread < threads ? 1 : 0;
            ASSERT_LE(calls[thread], largest) << "section " << section << ", thread " << thread;
        }
        ASSERT_EQ(calls[0], 1);
        for (const int share : shares) {
            ASSERT_EQ(share, section);
        }
        if (between.count() > 0) {
            std::this_thread::sleep_for(between);
        }
    }
}

TEST(ThreadPool, DoesTheWorkOfASectionOnceWhoeverComes) {
    for (const microseconds awake : {microseconds(0), microseconds(100), microseconds(1000000)}) {
        ThreadPool pool(awake);
        expect_sections(pool, 20, microseconds(0)); // nobody but the caller
        pool.start(4);
        expect_sections(pool, 2000, microseconds(0));
        expect_sections(pool, 50, microseconds(200));
    }
}

TEST(ThreadPool, CallsEveryWorkerThatIsWaitedFor) {
    for (const microseconds awake : {microseconds(0), microseconds(1000000)}) {
        ThreadPool pool(awake);
        pool.start(3);
        ASSERT_EQ(pool.size(), 3U);
        for (int section = 0; section < 200; ++section) {
            std::atomic<std::uint32_t> came = 0;
            pool.run(3, [&](std::uint32_t) {
                ++came;
                for (WaitingTurns turns; came < 3;) {
                    turns.wait();
                }
            });
            ASSERT_EQ(came, 3U);
        }
    }
}

// Wake-up calls during a section do not make a worker run its part twice.
TEST(ThreadPool, CallsAWorkerOnceHoweverOftenItIsRung) {
    ThreadPool pool(microseconds(1000000));
    pool.start(2);
    ASSERT_EQ(pool.size(), 2U);
    for (int section = 0; section < 20; ++section) {
        std::atomic<int> calls = 0;
        pool.run(2, [&](std::uint32_t thread) {
            if (thread != 0) {
                ++calls;
                return;
            }
            while (calls == 0) {
                std::this_thread::yield();
            }
            for (int ring = 0; ring < 20; ++ring) {
                pool.wake(2);
                std::this_thread::sleep_for(microseconds(50));
            }
        });
        ASSERT_EQ(calls, 1) << "section " << section;
    }
}

TEST(ThreadPool, SleepsAtOnceWhereWaitingIsToBePassive) {
    const char* before = std::getenv("OMP_WAIT_POLICY");
    const std::string kept = before == nullptr ? "" : before;
    ASSERT_EQ(setenv("OMP_WAIT_POLICY", "passive", 1), 0);
    EXPECT_EQ(default_awake_time().count(), 0);
    ASSERT_EQ(unsetenv("OMP_WAIT_POLICY"), 0);
    EXPECT_GT(default_awake_time().count(), 0);
    if (before != nullptr) {
        ASSERT_EQ(setenv("OMP_WAIT_POLICY", kept.c_str(), 1), 0);
    }
}

#if defined(__linux__)
// The number of cores that a process may use; 0 stands for this thread.
int cores_of(pid_t process) {
    cpu_set_t allowed;
    return sched_getaffinity(process, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : -1;
}

// This test runs again with OMP_PROC_BIND set, with which OpenMP binds the calling thread.
TEST(ThreadPool, LetsWorkersUseAllCoresWhereOpenMPBindsTheCaller) {
    const bool is_bound = std::getenv("OMP_PROC_BIND") != nullptr;
    ThreadPool pool;
    pool.start(2);
    std::atomic<int> cores = 0;
    pool.run(2, [&](std::uint32_t thread) {
        if (thread == 1) {
            cores = cores_of(0);
        }
        for (WaitingTurns turns; thread == 0 && cores == 0;) {
            turns.wait();
        }
    });
    // Before OpenMP bound this thread, it could use the cores of the parent process.
    EXPECT_EQ(cores, cores_of(is_bound ? getppid() : 0));
}

void move_to_core(std::size_t core) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    sched_setaffinity(0, sizeof one, &one);
}

// A step in three dimensions takes so long that the system moves the caller meanwhile.
TEST(ThreadPool, WorkersLeaveTheCoreToWhichTheCallerWasMoved) {
    cpu_set_t allowed;
    ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
    std::vector<std::size_t> cores;
    for (std::size_t core = 0; core < CPU_SETSIZE && cores.size() < 2; ++core) {
        if (CPU_ISSET(core, &allowed)) {
            cores.push_back(core);
        }
    }
    if (cores.size() < 2 || std::getenv("OMP_PROC_BIND") != nullptr) {
        GTEST_SKIP() << "one core, or bound to one";
    }
    cpu_set_t two; // the worker has no third core to go to
    CPU_ZERO(&two);
    for (const std::size_t core : cores) {
        CPU_SET(core, &two);
    }
    ASSERT_EQ(sched_setaffinity(0, sizeof two, &two), 0);
    ThreadPool pool(microseconds(1000000));
    pool.start(2);
    for (const std::size_t core : cores) {
        move_to_core(core);
        int beside = 0;
        int on_callers_core = 0;
        for (int section = 0; section < 300; ++section) {
            std::atomic<int> workers_core = -1;
            pool.run(2, [&](std::uint32_t thread) {
                if (thread == 1) {
                    workers_core = sched_getcpu();
                }
                const auto begin = std::chrono::steady_clock::now();
                while (thread == 0 && workers_core < 0 &&
                       std::chrono::steady_clock::now() - begin < microseconds(2000)) {
                }
            });
            beside += workers_core >= 0 && workers_core != static_cast<int>(core) ? 1 : 0;
            on_callers_core += workers_core == static_cast<int>(core) ? 1 : 0;
            std::this_thread::sleep_for(microseconds(300));
        }
        EXPECT_LE(on_callers_core, beside) << "core " << core;
        EXPECT_GT(beside, 0) << "core " << core;
    }
    sched_setaffinity(0, sizeof allowed, &allowed);
}
#endif

// A model of a machine on which a step with one unit of work takes `seconds(threads)`.
struct Machine {
    double one, two, four;
    [[nodiscard]] double seconds(std::uint32_t threads) const {
        return threads == 1 ? one : threads == 2 ? two : four;
    }
};

// Counts for each number of threads the steps that used it, among the last `counted` steps.
std::array<int, 5> run(ThreadChoice& choice, const Machine& machine, int steps, int counted,
                       std::uint32_t useful = 4) {
    std::array<int, 5> used{};
    for (int step = 0; step < steps; ++step) {
        const std::uint32_t threads = choice.threads();
        used.at(threads) += step >= steps - counted ? 1 : 0;
        const double work = 1 + step % 7; // steps take a time proportional to their work
        choice.took(machine.seconds(threads) * work, work, useful);
    }
    return used;
}

TEST(ThreadChoice, StaysWithAllThreadsWhereTheyPay) {
    ThreadChoice choice(2);
    EXPECT_EQ(choice.threads(), 1U);
    const auto used = run(choice, {1.0, 0.6, 0}, 2000, 2000);
    EXPECT_GT(used[2], 1970) << "tries are short, and become rare";
    EXPECT_GT(used[1], 4) << "tries are made";
}

TEST(ThreadChoice, LeavesOutThreadsThatDoNotPay) {
    ThreadChoice choice(4);
    const auto first = run(choice, {0.5, 0.8, 1.0}, 20, 20);
    EXPECT_LE(first[4], 3) << "it begins with one, and sees at once that four take longer";
    const auto used = run(choice, {0.5, 0.8, 1.0}, 400, 200);
    EXPECT_GT(used[1], 180);
}

TEST(ThreadChoice, FollowsWhatElseRunsOnTheMachine) {
    ThreadChoice choice(2);
    (void)run(choice, {1.0, 0.6, 0}, 3000, 1); // tries have become rare
    const auto busy = run(choice, {1.0, 2.0, 0}, 200, 100);
    EXPECT_GT(busy[1], 85) << "a step that takes three times as long is noticed at once";
    const auto quiet = run(choice, {1.0, 0.6, 0}, 400, 100);
    EXPECT_GT(quiet[2], 85) << "and so is that the others have gone, if not at once";
}

TEST(ThreadChoice, IsNotDeceivedByOneSlowStep) {
    ThreadChoice choice(2);
    (void)run(choice, {1.0, 0.6, 0}, 100, 1);
    choice.took(1000, 1, 2);
    const auto used = run(choice, {1.0, 0.6, 0}, 100, 100);
    EXPECT_GT(used[2], 90);
}

// While the interface is too short for a second thread, the times for one and two threads differ
// only by noise.
TEST(ThreadChoice, TriesAllThreadsOnceTheyHaveSomethingToDo) {
    ThreadChoice choice(2);
    (void)run(choice, {0.9, 1.0, 0}, 5000, 1, 1);
    const auto used = run(choice, {1.0, 0.6, 0}, 40, 40, 2);
    EXPECT_GT(used[2], 30);
}

} // namespace
} // namespace dsc::thread_pool_test
