// SPDX-License-Identifier: MIT
// A model of whole runs in three dimensions with more threads than the machine has: the tasks of
// each section of a measured run are given to n workers in the order in which threads take them;
// the rest of the run is serial. As for `model.h`, results are labelled as modelled.
#pragma once

#include "dsc3/parallel/team.h"
#include "steps/model.h"

#include <cstdint>
#include <vector>

namespace dsc::bench {

/// The times of the steps of a run, in seconds.
struct SpaceProfile {
    std::vector<std::vector<double>> sections; ///< the seconds of their tasks
    std::vector<double> walls;                 ///< by section
    double wall = 0;                           ///< of all steps
    int steps = 0;

    /// Adds the times of a step.
    void add(const dsc3::StepProfile& step, double step_wall);
    /// Of all tasks.
    [[nodiscard]] double tasks() const;
    /// Of the parts of the steps outside of sections.
    [[nodiscard]] double serial() const;
};

/// The seconds from the start of the first task to the end of the last one.
[[nodiscard]] double makespan(const std::vector<double>& tasks, std::uint32_t workers);

/// `start_s` as for `model` of a `ModelRun`.
[[nodiscard]] ModelTimes model(const SpaceProfile& run, std::uint32_t workers, double start_s);

/// As for a `ModelRun`: `run` must be measured with this number of threads.
[[nodiscard]] double measured_start(const SpaceProfile& run, std::uint32_t workers);

} // namespace dsc::bench
