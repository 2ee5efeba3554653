// SPDX-License-Identifier: MIT
#include "steps/model.h"

#include "dsc/base/error.h"
#include "dsc/parallel/in_place/schedule.h"
#include "dsc/parallel/submesh_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace dsc::bench {

namespace {

constexpr double never = 1e300;

double sum(const std::vector<double>& values) {
    double total = 0;
    for (const double value : values) {
        total += value;
    }
    return total;
}

void add(ModelAccount& account, const SubStepProfile& one) {
    account.set_up += one.set_up;
    account.hand_over += one.hand_over;
    account.clean_up += one.clean_up;
    account.wall += one.targets_wall + one.move_wall;
    account.targets += sum(one.targets);
    account.tasks += sum(one.targets) + sum(one.move);
    for (std::size_t i = one.targets.size(); i < one.move.size(); ++i) {
        account.later += one.move[i];
    }
}

} // namespace

double levels(std::uint32_t workers) { return std::ceil(std::log2(workers)); }

double makespan(const Section& section, std::uint32_t workers, Assignment assignment) {
    const TaskGraph& tasks = section.tasks;
    const std::size_t n = tasks.size();
    std::vector<double> ended(n, never);
    std::vector<bool> taken(n, false);
    std::vector<double> free_at(workers, 0);
    std::vector<double> busy(workers, 0);
    std::vector<double> late_at(workers, 0); // idle for the mean time of its tasks
    std::vector<int> done(workers, 0);
    std::size_t left = n;
    double last = 0;
    const auto is_ready = [&](std::size_t task, double now) {
        return std::ranges::all_of(tasks.predecessors(task),
                                   [&](std::uint32_t earlier) { return ended[earlier] <= now; });
    };
    // As in `Schedule`: the last task of a worker that has already started others.
    const auto is_last_one = [&](std::size_t task) {
        bool has_begun = false;
        for (std::size_t other = 0; other < n; ++other) {
            if (other != task && tasks.home_of(other, workers) == tasks.home_of(task, workers)) {
                if (!taken[other]) {
                    return false;
                }
                has_begun = true;
            }
        }
        return has_begun;
    };
    while (left > 0) {
        const auto worker = static_cast<std::uint32_t>(
            std::min_element(free_at.begin(), free_at.end()) - free_at.begin());
        const double now = free_at[worker];
        std::size_t next = n;
        bool has_work = false; // its own, or any
        for (std::size_t task = 0; task < n && next == n; ++task) {
            if (!taken[task] && tasks.home_of(task, workers) == worker) {
                has_work = true;
                next = is_ready(task, now) ? task : next;
            }
        }
        for (std::size_t i = n; i > 0 && next == n && assignment == Assignment::queue; --i) {
            if (!taken[i - 1]) {
                has_work = true;
                const bool may_be_taken = now >= late_at[worker] || !is_last_one(i - 1);
                next = may_be_taken && is_ready(i - 1, now) ? i - 1 : next;
            }
        }
        if (next < n) {
            taken[next] = true;
            --left;
            ended[next] = now + section.seconds[next];
            free_at[worker] = ended[next];
            busy[worker] += section.seconds[next];
            late_at[worker] = ended[next] + busy[worker] / ++done[worker];
            last = std::max(last, ended[next]);
        } else {
            // No work yet: wakes when the next task ends or a worker becomes late, or never.
            double wake = now < late_at[worker] ? late_at[worker] : never;
            for (const double end : ended) {
                wake = end > now ? std::min(wake, end) : wake;
            }
            free_at[worker] = has_work ? wake : never;
        }
    }
    return last;
}

void add_step(ModelRun& run, const SubmeshView& submeshes, double wall) {
    auto& step = run.steps.emplace_back();
    double inside = 0;
    for (const SubStepProfile& profile : submeshes.profile) {
        ModelSubStep& sub_step = step.emplace_back();
        sub_step.serial = profile.set_up + profile.hand_over + profile.clean_up;
        sub_step.targets.tasks.add_colour(profile.targets.size());
        sub_step.targets.seconds = profile.targets;
        sub_step.move.seconds = profile.move;
        sub_step.targets.wall = profile.targets_wall;
        sub_step.move.wall = profile.move_wall;
        std::size_t first = 0;
        for (const Colour& colour : submeshes.partition.colours) {
            sub_step.move.tasks.add_colour(colour.regions.size());
            for (std::size_t i = 0; i < colour.regions.size(); ++i) {
                for (const std::uint32_t earlier : submeshes.tasks.predecessors(first + i)) {
                    sub_step.move.tasks.wait_for(first + i, earlier);
                }
            }
            first += colour.regions.size();
        }
        inside += sub_step.serial + profile.targets_wall + profile.move_wall;
        add(run.account, profile);
    }
    run.serial_outside.push_back(std::max(0.0, wall - inside));
}

ModelTimes model(const ModelRun& run, std::uint32_t workers, double start_s) {
    const double start = start_s * levels(workers);
    ModelTimes times;
    times.serial = sum(run.serial_outside);
    double parallel = 0;
    for (const auto& step : run.steps) {
        for (const ModelSubStep& sub_step : step) {
            times.serial += sub_step.serial;
            times.tasks += sum(sub_step.targets.seconds) + sum(sub_step.move.seconds);
            times.starts += 2 * start;
            parallel += makespan(sub_step.targets, workers, Assignment::queue) +
                        makespan(sub_step.move, workers, Assignment::queue) + 2 * start;
        }
    }
    times.seconds = times.serial + parallel;
    times.serial_share = times.serial / (times.serial + times.tasks);
    times.busy_share = times.tasks / (parallel * workers);
    return times;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double measured_start(const ModelRun& run, std::uint32_t workers) {
    std::vector<double> rest;
    for (const auto& step : run.steps) {
        for (const ModelSubStep& sub_step : step) {
            for (const Section* section : {&sub_step.targets, &sub_step.move}) {
                rest.push_back(section->wall - makespan(*section, workers, Assignment::queue));
            }
        }
    }
    if (workers <= 1 || rest.empty()) {
        return 0;
    }
    return std::max(0.0, median(std::move(rest)) / levels(workers));
}

double measure_bandwidth(std::uint32_t threads) {
    using Clock = std::chrono::steady_clock;
    constexpr std::size_t size = std::size_t{1} << 23U; // 64 MiB each
    constexpr int passes = 8;
    std::vector<double> a(size);
    std::vector<double> b(size, 1.0);
    std::vector<double> c(size, 2.0);
    ThreadPool pool;
    pool.start(threads);
    Schedule schedule;
    schedule.tasks.add_colour(threads);
    double best = never;
    for (int i = 0; i < passes; ++i) {
        const auto begin = Clock::now();
        schedule.run(pool, threads, Assignment::queue, [&](std::size_t task) {
            for (std::size_t k = size * task / threads; k < size * (task + 1) / threads; ++k) {
                a[k] = b[k] + 3 * c[k];
            }
        });
        best = std::min(best, std::chrono::duration<double>(Clock::now() - begin).count());
    }
    if (a[size / 2] != 7) {
        throw InvariantError("the sums of the bandwidth test are wrong");
    }
    return 3 * sizeof(double) * static_cast<double>(size) / best;
}

double measure_fork_join(std::uint32_t threads) {
    using Clock = std::chrono::steady_clock;
    ThreadPool pool;
    pool.start(threads);
    Schedule schedule;
    schedule.tasks.add_colour(threads);
    std::vector<double> seconds;
    constexpr int times = 4000;
    for (int i = 0; i < times; ++i) {
        const auto begin = Clock::now();
        schedule.run(pool, threads, Assignment::queue, [](std::size_t) {});
        seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    }
    std::sort(seconds.begin(), seconds.end());
    return seconds[seconds.size() / 2];
}

} // namespace dsc::bench
