// SPDX-License-Identifier: MIT
// Runs the array of combinations, or one row of it: see --help. The tests of the array are
// combinations_test.cpp; this is for who looks for what a row needs to fail.
#include "combinations/sense.h"
#include "combinations/trial.h"

#include "dsc/base/error.h"

#include <CLI/CLI.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

namespace dsc::combinations {
namespace {

struct Settings {
    std::string row;
    std::size_t strength = 2;
    std::uint64_t seed = 1;
    int jobs = 2;
    rlim_t limit_s = 20;
    double fineness = 1;
};

// A row in a process of its own, which may hang or crash. It prints its problems.
pid_t begin(const Values& values, const Settings& settings, bool is_silent = false) {
    std::cout.flush();
    const pid_t id = fork();
    if (id != 0) {
        return id;
    }
    const rlimit limit{settings.limit_s, settings.limit_s};
    setrlimit(RLIMIT_CPU, &limit);
    const Findings findings = try_row(row_of(values), settings.fineness);
    if (!is_silent) {
        if (!settings.row.empty()) {
            std::cout << "off by " << findings.mean.off << " edge lengths, allowed "
                      << findings.mean.allowed << "; a vertex by " << findings.farthest.off
                      << ", allowed " << findings.farthest.allowed << '\n';
        }
        for (const std::string& problem : findings.problems) {
            std::cout << "  " << problem << '\n';
        }
        std::cout.flush();
    }
    _exit(findings.problems.empty() ? 0 : 1);
}

// Whether the row of this process holds; one that hangs or crashes does not.
bool holds(pid_t id) {
    int status = 0;
    return waitpid(id, &status, 0) == id && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// Features are switched off one by one while the row still fails.
Values cut_down(Values values, const Settings& settings) {
    for (bool is_smaller = true; is_smaller;) {
        is_smaller = false;
        for (std::size_t i = 0; i < feature_count; ++i) {
            Values plainer = values;
            plainer[i] = 0;
            if (values[i] != 0 && nonsense_in(plainer).empty() &&
                !holds(begin(plainer, settings, true))) {
                values = plainer;
                is_smaller = true;
            }
        }
    }
    return values;
}

// As many rows at a time as there are jobs. Returns how many fail.
std::size_t run_rows(const std::vector<Values>& rows, const Settings& settings) {
    std::size_t failed = 0;
    const auto jobs = static_cast<std::size_t>(settings.jobs);
    for (std::size_t from = 0; from < rows.size(); from += jobs) {
        std::vector<pid_t> children;
        for (std::size_t i = from; i < std::min(rows.size(), from + jobs); ++i) {
            children.push_back(begin(rows[i], settings));
        }
        for (std::size_t i = 0; i < children.size(); ++i) {
            if (!holds(children[i])) {
                ++failed;
                std::cout << "fails: dsc_combinations --row '" << words_of(rows[from + i])
                          << "'\n  cut down: --row '"
                          << words_of(cut_down(rows[from + i], settings)) << "'" << std::endl;
            }
        }
    }
    return failed;
}

int run(const Settings& settings) {
    if (!settings.row.empty()) {
        const Values values = values_of(settings.row);
        if (const std::string_view why = nonsense_in(values); !why.empty()) {
            std::cout << "makes no sense: " << why << '\n';
            return 2;
        }
        return holds(begin(values, settings)) ? 0 : 1;
    }
    const Cover cover = cover_features(settings.strength, settings.seed);
    std::vector<Values> rows;
    for (const auto& row : cover.rows) {
        std::copy_n(row.begin(), feature_count, rows.emplace_back().begin());
    }
    const std::size_t failed = run_rows(rows, settings);
    std::cout << cover.covered << " of " << cover.combinations << " combinations of "
              << settings.strength << " values in " << rows.size() << " rows; " << cover.senseless
              << " make no sense; " << failed << " rows fail\n";
    return failed == 0 ? 0 : 1;
}

} // namespace
} // namespace dsc::combinations

int main(int argc, char** argv) {
    dsc::combinations::Settings settings;
    CLI::App app("Runs combinations of features whose answers are known from their parts. A row "
                 "that fails is cut down to the features that it needs for that.");
    app.add_option("--row", settings.row, "only this row, e.g. 'motion=turn way=cells'");
    app.add_option("--strength", settings.strength, "so many features at a time")
        ->check(CLI::Range(1, 4));
    app.add_option("--seed", settings.seed, "another one makes other rows");
    app.add_option("--jobs", settings.jobs, "rows at a time")->check(CLI::Range(1, 64));
    app.add_option("--limit", settings.limit_s,
                   "seconds of the processor after which a row counts as hanging");
    app.add_option("--fineness", settings.fineness, "divides the length of edges")
        ->check(CLI::Range(0.5, 16.0));
    CLI11_PARSE(app, argc, argv);
    try {
        return dsc::combinations::run(settings);
    } catch (const dsc::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
