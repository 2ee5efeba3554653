// SPDX-License-Identifier: MIT
#include "steps/space/model.h"

#include <algorithm>
#include <numeric>

namespace dsc::bench {

void SpaceProfile::add(const dsc3::StepProfile& step, double step_wall) {
    wall += step_wall;
    ++steps;
    for (std::size_t i = 0; i < step.sections.size(); ++i) {
        const auto at = [&](std::size_t section) {
            return step.tasks.begin() +
                   static_cast<std::ptrdiff_t>(section < step.sections.size()
                                                   ? step.sections[section].first_task
                                                   : step.tasks.size());
        };
        sections.emplace_back(at(i), at(i + 1));
        walls.push_back(step.sections[i].wall);
    }
}

double SpaceProfile::tasks() const {
    double total = 0;
    for (const auto& section : sections) {
        total = std::accumulate(section.begin(), section.end(), total);
    }
    return total;
}

double SpaceProfile::serial() const {
    return std::max(0.0, wall - std::accumulate(walls.begin(), walls.end(), 0.0));
}

double makespan(const std::vector<double>& tasks, std::uint32_t workers) {
    std::vector<double> free_at(workers, 0);
    for (const double seconds : tasks) {
        *std::min_element(free_at.begin(), free_at.end()) += seconds;
    }
    return *std::max_element(free_at.begin(), free_at.end());
}

ModelTimes model(const SpaceProfile& run, std::uint32_t workers, double start_s) {
    ModelTimes times;
    times.serial = run.serial();
    times.tasks = run.tasks();
    double parallel = 0;
    for (const auto& section : run.sections) {
        const auto at_work = std::min<std::size_t>(workers, section.size());
        const double start =
            at_work > 1 ? start_s * levels(static_cast<std::uint32_t>(at_work)) : 0;
        times.starts += start;
        parallel += start + makespan(section, workers);
    }
    times.seconds = times.serial + parallel;
    times.serial_share = times.serial / (times.serial + times.tasks);
    times.busy_share = times.tasks / (parallel * workers);
    return times;
}

double measured_start(const SpaceProfile& run, std::uint32_t workers) {
    std::vector<double> rest;
    for (std::size_t i = 0; i < run.sections.size(); ++i) {
        if (run.sections[i].size() > 1) {
            rest.push_back(run.walls[i] - makespan(run.sections[i], workers));
        }
    }
    return workers <= 1 || rest.empty() ? 0 : std::max(0.0, median(rest) / levels(workers));
}

} // namespace dsc::bench
