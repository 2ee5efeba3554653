// SPDX-License-Identifier: MIT
// Each task runs once, after all its predecessors; an exception in a task is passed on, and the
// schedule can be used again.
#include "dsc/parallel/in_place/schedule.h"
#include "dsc/parallel/submesh_view.h"

#include "support/enum_values.h"
#include "support/random/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace dsc::schedule_test {
namespace {

using test::Dice;

constexpr std::array assignments = test::values_in(assignment_names);

std::string name_of(Assignment assignment) { return std::string(to_string(assignment)); }

// Colours of up to `largest` tasks; a task waits for some of the earlier colours, most often for a
// few of the previous one.
void draw_graph(Dice& dice, TaskGraph& graph, int largest) {
    const int colours = dice.in(1, 4);
    for (int colour = 0; colour < colours; ++colour) {
        const int count = dice.in(1, largest);
        const auto first = static_cast<int>(graph.add_colour(static_cast<std::size_t>(count)));
        for (int task = first; task < first + count && first > 0; ++task) {
            const int smallest = dice.chance(0.8) ? std::max(0, first - 8) : 0;
            std::vector<int> earlier;
            for (int i = dice.in(0, 4); i > 0; --i) {
                earlier.push_back(dice.in(smallest, first - 1));
            }
            std::sort(earlier.begin(), earlier.end());
            earlier.erase(std::unique(earlier.begin(), earlier.end()), earlier.end());
            for (const int i : earlier) {
                graph.wait_for(static_cast<std::size_t>(task), static_cast<std::size_t>(i));
            }
        }
    }
}

// The results of the tasks, each a plain number computed from those of its predecessors: wrong if
// one of them had not ended, and a race for the thread sanitizer if the flags do not order the two.
class Record {
public:
    explicit Record(const TaskGraph& graph)
        : graph_(graph), values_(graph.size(), 0), threads_(graph.size()),
          runs_(std::make_unique<std::atomic<int>[]>(graph.size())) {}

    void run(std::size_t task, int turns = 0) {
        ++runs_[task];
        volatile double spent = 1;
        for (int i = 0; i < turns; ++i) {
            spent = std::sqrt(spent + i);
        }
        threads_[task] = std::this_thread::get_id();
        values_[task] = value_of(task, values_);
    }

    [[nodiscard]] int runs(std::size_t task) const { return runs_[task]; }
    [[nodiscard]] std::thread::id thread(std::size_t task) const { return threads_[task]; }

    void expect_all_once() const {
        std::vector<std::uint64_t> expected(graph_.size(), 0);
        for (std::size_t task = 0; task < graph_.size(); ++task) {
            expected[task] = value_of(task, expected);
            ASSERT_EQ(runs(task), 1) << "task " << task;
            ASSERT_EQ(values_[task], expected[task])
                << "task " << task << " began before its predecessors had ended";
        }
    }

private:
    [[nodiscard]] std::uint64_t value_of(std::size_t task,
                                         const std::vector<std::uint64_t>& values) const {
        std::uint64_t value = task + 1;
        for (const std::uint32_t earlier : graph_.predecessors(task)) {
            value = value * 1000003 + values[earlier];
        }
        return value;
    }

    const TaskGraph& graph_;
    std::vector<std::uint64_t> values_;
    std::vector<std::thread::id> threads_;
    std::unique_ptr<std::atomic<int>[]> runs_;
};

// Static assignment: neighbours in a colour are on the same thread, and the threads have the same
// number of tasks of each colour, up to a difference of one.
TEST(TaskGraph, SharesEachColourAmongTheThreads) {
    for (const std::uint32_t tasks : {1U, 2U, 5U, 16U, 37U}) {
        TaskGraph graph;
        (void)graph.add_colour(3);
        const std::size_t first = graph.add_colour(tasks);
        for (const std::uint32_t threads : {1U, 2U, 3U, 6U, 64U}) {
            std::vector<std::uint32_t> count(threads, 0);
            std::uint32_t last = 0;
            for (std::size_t i = 0; i < tasks; ++i) {
                const std::uint32_t home = graph.home_of(first + i, threads);
                ASSERT_LT(home, threads);
                EXPECT_GE(home, last);
                last = home;
                ++count[home];
            }
            const auto [smallest, largest] = std::minmax_element(count.begin(), count.end());
            EXPECT_LE(*largest - *smallest, 1U) << tasks << " tasks, " << threads << " threads";
        }
    }
}

TEST(Schedule, RunsEachTaskOnceAndAfterItsPredecessors) {
    Dice dice(1);
    ThreadPool pool;
    pool.start(6);
    Schedule schedule; // one schedule is reused for all graphs, larger and smaller ones
    for (int round = 0; round < 60; ++round) {
        schedule.tasks.clear();
        draw_graph(dice, schedule.tasks, round % 3 == 0 ? 40 : 8);
        for (std::uint32_t threads = 1; threads <= 6; ++threads) {
            for (const Assignment assignment : assignments) {
                SCOPED_TRACE("round " + std::to_string(round) + ", threads " +
                             std::to_string(threads) + ", " + name_of(assignment));
                Record record(schedule.tasks);
                // Some take up to a millisecond: longer than any thread spins before it yields.
                const int longest = round % 6 == 0 ? 200'000 : 0;
                schedule.run(pool, threads, assignment, [&](std::size_t task) {
                    record.run(task, task % 5 == 0 ? longest : 0);
                });
                record.expect_all_once();
                if (assignment == Assignment::fixed) {
                    std::map<std::uint32_t, std::thread::id> homes;
                    for (std::size_t task = 0; task < schedule.tasks.size(); ++task) {
                        const std::uint32_t home =
                            schedule.tasks.home_of(task, std::min(threads, pool.size()));
                        EXPECT_EQ(record.thread(task),
                                  homes.emplace(home, record.thread(task)).first->second)
                            << "task " << task;
                    }
                }
                if (HasFatalFailure()) {
                    return;
                }
            }
        }
    }
}

// The first task of thread 0 waits until all other tasks of thread 0 have run, so another thread
// must take these over.
TEST(Schedule, TakesOverWhatNobodyHasBegun) {
    ThreadPool pool;
    pool.start(2);
    ASSERT_EQ(pool.size(), 2U);
    Schedule schedule;
    constexpr std::size_t tasks = 8;
    (void)schedule.tasks.add_colour(tasks);
    std::atomic<int> others{0};
    std::size_t mine = 0;
    bool in_time = true;
    schedule.run(pool, 2, Assignment::queue, [&](std::size_t task) {
        if (schedule.tasks.home_of(task, 2) != 0) {
            return;
        }
        if (task != 0) {
            ++others;
            return;
        }
        const auto begin = std::chrono::steady_clock::now();
        while (others < static_cast<int>(tasks / 2 - 1) && in_time) {
            in_time = std::chrono::steady_clock::now() - begin < std::chrono::seconds(60);
            std::this_thread::yield();
        }
        ++mine;
    });
    EXPECT_TRUE(in_time) << "nobody took the tasks over";
    EXPECT_EQ(mine, 1U);
    EXPECT_EQ(others, static_cast<int>(tasks / 2 - 1));
}

struct Fault : std::runtime_error {
    explicit Fault(std::size_t task)
        : std::runtime_error("task " + std::to_string(task)), number(task) {}
    std::size_t number;
};

TEST(Schedule, ThrowsOnWhatATaskThrewAndRunsAllButThoseThatWaitForIt) {
    Dice dice(3);
    ThreadPool pool;
    pool.start(6);
    Schedule schedule;
    std::size_t kept_from_running = 0;
    for (int round = 0; round < 40; ++round) {
        schedule.tasks.clear();
        draw_graph(dice, schedule.tasks, 16);
        const std::size_t size = schedule.tasks.size();
        std::vector<std::uint8_t> is_faulty(size, 0);
        for (int i = dice.in(1, 3); i > 0; --i) {
            is_faulty[static_cast<std::size_t>(dice.in(0, static_cast<int>(size) - 1))] = 1;
        }
        for (std::uint32_t threads = 1; threads <= 6; ++threads) {
            for (const Assignment assignment : assignments) {
                SCOPED_TRACE("round " + std::to_string(round) + ", threads " +
                             std::to_string(threads) + ", " + name_of(assignment));
                Record record(schedule.tasks);
                std::size_t thrown = size;
                try {
                    schedule.run(pool, threads, assignment, [&](std::size_t task) {
                        record.run(task);
                        if (is_faulty[task] != 0) {
                            throw Fault(task);
                        }
                    });
                } catch (const Fault& fault) {
                    thrown = fault.number;
                }
                ASSERT_LT(thrown, size) << "nothing came out";
                EXPECT_NE(is_faulty[thrown], 0);
                EXPECT_EQ(record.runs(thrown), 1);
                std::vector<std::uint8_t> is_lost(is_faulty); // failed, or waits for a failed one
                for (std::size_t task = 0; task < size; ++task) {
                    bool waits_for_lost = false;
                    for (const std::uint32_t earlier : schedule.tasks.predecessors(task)) {
                        waits_for_lost = waits_for_lost || is_lost[earlier] != 0;
                    }
                    is_lost[task] = waits_for_lost ? 1 : is_lost[task];
                    kept_from_running += waits_for_lost ? 1 : 0;
                    // The set of tasks that run does not depend on the threads.
                    EXPECT_EQ(record.runs(task), waits_for_lost ? 0 : 1) << "task " << task;
                    if (record.runs(task) == 1 && is_faulty[task] != 0) {
                        EXPECT_GE(task, thrown) << "the first one is to come out";
                    }
                }
                // The schedule works again after a failure.
                Record again(schedule.tasks);
                schedule.run(pool, threads, assignment, [&](std::size_t task) { again.run(task); });
                again.expect_all_once();
                if (HasFatalFailure()) {
                    return;
                }
            }
        }
    }
    EXPECT_GT(kept_from_running, 1000U) << "hardly anything waited for a faulty task";
}

} // namespace
} // namespace dsc::schedule_test
