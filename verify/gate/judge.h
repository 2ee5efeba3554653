// SPDX-License-Identifier: MIT
// The judgement: makes the checks of all cases and compares them with their limits.
#pragma once

#include "suite.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dsc::gate {

/// A check to be made. The case must outlive it.
struct Task {
    const Case* of = nullptr;
    const Held* held = nullptr;
};

/// All limits of these cases, or those of the named checks and groups: first those of scene files,
/// then check by check in the order of the table. Throws InputError for an unknown name, and if
/// there is no such limit.
[[nodiscard]] std::vector<Task> tasks_of(const Cases& cases, const std::vector<std::string>& only);

/// The place where a limit is broken; see place.h.
struct Place {
    std::string what{};                ///< in words; empty if nothing was found
    std::optional<Point<double>> at{}; ///< in units of the domain
    double time = 0;
    std::string picture{}; ///< a file; empty: none
    std::string edits{};   ///< the log of edits up to this state; empty: none
    std::string command{}; ///< repeats the run
};

struct Row {
    const Case* of = nullptr;
    const Check* check = nullptr;
    Limit limit{};
    std::optional<double> measured{};   ///< empty if the run failed
    std::optional<Configuration> run{}; ///< the run from which the figure comes
    bool pass = false;
    std::string failure{}; ///< the exception of the run, or why a figure within its limit fails
    Place place{};         ///< of a broken limit
    double seconds = 0;    ///< of the runs that no previous row has used
};

/// Compares the figure of a check with its limit. `drift`: a figure also fails if it is worse than
/// the limit's `measured` by more than this fraction. Never throws because of a run.
[[nodiscard]] Row judge(const Task& task, std::span<const Outcome* const> outcomes,
                        std::optional<double> drift = {});

/// All runs of these tasks.
[[nodiscard]] std::vector<Configuration> configurations_of(const std::vector<Task>& tasks);

/// Judges the tasks in their order, each as soon as its runs are finished.
[[nodiscard]] std::vector<Row> judge_all(const std::vector<Task>& tasks, Runs& runs,
                                         std::optional<double> drift,
                                         const std::function<void(const Row&)>& tell);

} // namespace dsc::gate
