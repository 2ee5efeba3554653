// SPDX-License-Identifier: MIT
#include "judge.h"

#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/name_list.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace dsc::gate {

namespace {

// Each check of these cases once, those of scene files first.
std::vector<const Check*> checks_of(const Cases& cases) {
    std::vector<const Check*> checks;
    for (const auto& c : cases) {
        for (const Held& held : c->held) {
            const bool is_of_file =
                std::ranges::find(all_checks(), held.check) == all_checks().end();
            if (is_of_file &&
                std::ranges::find(checks, held.check->name, &Check::name) == checks.end()) {
                checks.push_back(held.check.get());
            }
        }
    }
    for (const auto& check : all_checks()) {
        checks.push_back(check.get());
    }
    return checks;
}

void check_known(const std::vector<const Check*>& checks, const std::vector<std::string>& only) {
    for (const std::string& name : only) {
        if (std::ranges::none_of(checks, [&](const Check* one) { return one->is_called(name); })) {
            throw InputError({.what = "unknown check",
                              .where = "run",
                              .value = scenes::quoted_excerpt(name),
                              .allowed = scenes::name_list(checks, &Check::name)});
        }
    }
}

} // namespace

std::vector<Task> tasks_of(const Cases& cases, const std::vector<std::string>& only) {
    const std::vector<const Check*> checks = checks_of(cases);
    check_known(checks, only);
    std::vector<Task> tasks;
    for (const Check* check : checks) {
        if (!only.empty() && std::ranges::none_of(only, [&](const std::string& name) {
                return check->is_called(name);
            })) {
            continue;
        }
        for (const auto& c : cases) {
            for (const Held& held : c->held) {
                if (held.check->name == check->name) {
                    tasks.push_back({c.get(), &held});
                }
            }
        }
    }
    if (tasks.empty()) {
        throw InputError({.what = "no limit of these checks",
                          .where = "run",
                          .value = only.empty() ? "" : only.front(),
                          .allowed = "checks for which a case has a limit"});
    }
    return tasks;
}

std::vector<Configuration> configurations_of(const std::vector<Task>& tasks) {
    std::vector<Configuration> all;
    for (const Task& task : tasks) {
        std::ranges::move(configurations_of(*task.held->check, *task.of), std::back_inserter(all));
    }
    return all;
}

Row judge(const Task& task, std::span<const Outcome* const> outcomes,
          const Strictness& strictness) {
    Row row{.of = task.of, .check = task.held->check.get(), .limit = task.held->limit};
    const bool at_least = row.check->at_least;
    try {
        Measured measured = measure(*row.check, outcomes);
        if (row.limit.around) {
            measured.value = std::abs(measured.value - *row.limit.around);
        }
        row.measured = measured.value;
        row.run = measured.run;
        // Written so that NaN fails.
        row.pass = at_least ? measured.value >= row.limit.value : measured.value <= row.limit.value;
        if (row.pass && strictness.drift &&
            row.limit.worse_by(measured.value, at_least) > *strictness.drift) {
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

std::vector<Row> judge_all(const std::vector<Task>& tasks, Runs& runs, const Strictness& strictness,
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
        rows.push_back(judge(task, outcomes, strictness));
        rows.back().seconds = seconds;
        tell(rows.back());
    }
    return rows;
}

} // namespace dsc::gate
