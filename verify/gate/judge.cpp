// SPDX-License-Identifier: MIT
#include "judge.h"

#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace dsc::gate {

std::vector<Task> tasks_of(const Cases& cases, const std::vector<std::string>& only) {
    std::vector<Task> tasks;
    for (const auto& c : cases) {
        for (const Held& held : c->held) {
            tasks.push_back({c.get(), &held});
        }
    }
    for (const std::string& name : only) {
        const auto is_called = [&](const auto& check) { return check->is_called(name); };
        const auto check_of = [](const Task& task) { return task.held->check; };
        if (std::ranges::none_of(all_checks(), is_called) &&
            std::ranges::none_of(tasks, is_called, check_of)) {
            throw InputError({.what = "unknown check",
                              .where = "run",
                              .value = scenes::quoted_excerpt(name),
                              .allowed = scenes::name_list(
                                  all_checks(), [](const auto& one) { return one->name; })});
        }
    }
    std::erase_if(tasks, [&](const Task& task) {
        return !only.empty() && std::ranges::none_of(only, [&](const std::string& name) {
            return task.held->check->is_called(name);
        });
    });
    if (tasks.empty()) {
        throw InputError({.what = "no case has a limit for these checks",
                          .where = "run",
                          .value = only.empty() ? "" : only.front(),
                          .allowed = "checks for which a case has a limit"});
    }
    // Checks of scene files come first; they are not in the table of checks.
    std::ranges::stable_sort(tasks, {}, [](const Task& task) {
        const auto place = std::ranges::find(all_checks(), task.held->check);
        return place == all_checks().end() ? -1 : place - all_checks().begin();
    });
    return tasks;
}

std::vector<Configuration> configurations_of(const std::vector<Task>& tasks) {
    std::vector<Configuration> all;
    for (const Task& task : tasks) {
        std::ranges::move(configurations_of(*task.held->check, *task.of), std::back_inserter(all));
    }
    return all;
}

Row judge(const Task& task, std::span<const Outcome* const> outcomes, std::optional<double> drift) {
    Row row{.of = task.of, .check = task.held->check.get(), .limit = task.held->limit};
    const bool at_least = row.check->at_least;
    try {
        const Measured measured = measure(*row.check, row.limit, outcomes);
        row.measured = measured.value;
        row.run = measured.run;
        // Written so that NaN fails.
        row.pass = at_least ? measured.value >= row.limit.value : measured.value <= row.limit.value;
        if (row.pass && drift && row.limit.worse_by(measured.value, at_least) > *drift) {
            row.pass = false;
            row.failure = "within its limit, but worse than the " + to_text(*row.limit.measured) +
                          " that the limit was made from";
        }
    } catch (const GaveUp& error) {
        row.failure = error.what();
        row.run = error.run();
    } catch (const std::exception& error) {
        row.failure = error.what();
    }
    return row;
}

std::vector<Row> judge_all(const std::vector<Task>& tasks, Runs& runs, std::optional<double> drift,
                           const std::function<void(const Row&)>& tell) {
    std::vector<Row> rows;
    std::set<const Outcome*> seen;
    for (const Task& task : tasks) {
        std::vector<const Outcome*> outcomes;
        double seconds = 0;
        for (const Configuration& one : configurations_of(*task.held->check, *task.of)) {
            outcomes.push_back(&runs.wait(one));
            seconds += seen.insert(outcomes.back()).second ? outcomes.back()->seconds : 0;
        }
        rows.push_back(judge(task, outcomes, drift));
        rows.back().seconds = seconds;
        tell(rows.back());
    }
    return rows;
}

} // namespace dsc::gate
