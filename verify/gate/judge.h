// SPDX-License-Identifier: MIT
// The judgement: which checks are made of which cases, and whether their limits hold.
#pragma once

#include "suite.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsc::gate {

/// A check that is to be made. The case outlives it.
struct Task {
    const Case* of = nullptr;
    const Held* held = nullptr;
};

/// All limits of these cases, or those of checks and groups that are named: those of scene files,
/// and then check by check, in the order of the table. Throws InputError for a name that no check
/// has, and if nothing is left.
[[nodiscard]] std::vector<Task> tasks_of(const Cases& cases, const std::vector<std::string>& only);

/// Where a limit is broken; see place.h.
struct Place {
    std::string what{};                ///< in words; empty if nothing was found
    std::optional<Point<double>> at{}; ///< in units of the domain
    double time = 0;
    std::string picture{}; ///< a file; empty: none
    std::string edits{};   ///< the log of edits that leads there; empty: none
    std::string command{}; ///< makes the run again
};

struct Row {
    const Case* of = nullptr;
    const Check* check = nullptr;
    Limit limit{};
    std::optional<double> measured{};   ///< empty if the run failed
    std::optional<Configuration> run{}; ///< that the figure is of
    bool pass = false;
    std::string failure{}; ///< what the run threw, or why a figure within its limit fails
    Place place{};         ///< of a limit that is broken
    double seconds = 0;    ///< of the runs that no row before it has looked at
};

/// Compares what a check measured with its limit. `drift`: a figure fails as well that is worse by
/// more than this share than the limit's own `measured`. Never throws because of a run.
[[nodiscard]] Row judge(const Task& task, std::span<const Outcome* const> outcomes,
                        std::optional<double> drift = {});

/// All runs of these tasks.
[[nodiscard]] std::vector<Configuration> configurations_of(const std::vector<Task>& tasks);

/// Judges the tasks in their order, each as soon as its runs are done.
[[nodiscard]] std::vector<Row> judge_all(const std::vector<Task>& tasks, Runs& runs,
                                         std::optional<double> drift,
                                         const std::function<void(const Row&)>& tell);

} // namespace dsc::gate
