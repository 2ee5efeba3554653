// SPDX-License-Identifier: MIT
// Runs the array of combinations: see --help.
#include "combinations/covering.h"
#include "combinations/sense.h"
#include "combinations/trial.h"

#include "dsc/base/error.h"

#include <CLI/CLI.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace dsc::combinations {
namespace {

// --- a row in a process of its own: it may hang or crash -----------------------------------------

struct Result {
    bool is_done = false; ///< it has ended by itself
    Distance mean;
    Distance farthest;
    std::uint32_t threads = 1;
    std::vector<std::string> problems;
    double seconds = 0;
};

struct Settings {
    std::string row;
    std::size_t strength = 2;
    std::uint64_t seed = 1;
    std::size_t most_rows = 1'000'000;
    std::size_t jobs = 2;
    rlim_t limit_s = 20;
    double fineness = 1;
    bool lists = false;
    bool cuts_down = true;
};

class Child {
public:
    Child(const Values& values, const Settings& settings) {
        std::array<int, 2> ends{};
        if (pipe(ends.data()) != 0) {
            throw std::runtime_error("no pipe");
        }
        id_ = fork();
        if (id_ < 0) {
            throw std::runtime_error("no process");
        }
        if (id_ == 0) {
            close(ends[0]);
            limit_time(settings.limit_s);
            write_result(values, settings.fineness, ends[1]);
            _exit(0);
        }
        close(ends[1]);
        end_ = ends[0];
    }

    Result wait() {
        std::string text;
        std::array<char, 4096> some{};
        for (ssize_t n = 0; (n = read(end_, some.data(), some.size())) > 0;) {
            text.append(some.data(), static_cast<std::size_t>(n));
        }
        close(end_);
        int status = 0;
        rusage used{};
        wait4(id_, &status, 0, &used);
        Result result;
        result.seconds = static_cast<double>(used.ru_utime.tv_sec) +
                         1e-6 * static_cast<double>(used.ru_utime.tv_usec);
        if (!WIFEXITED(status) || text.empty()) {
            const int signal = WTERMSIG(status);
            const bool hangs = signal == SIGALRM || signal == SIGXCPU || signal == SIGKILL;
            result.problems.push_back(hangs ? "hangs" : "ends by signal " + std::to_string(signal));
            return result;
        }
        result.is_done = true;
        std::istringstream lines(text);
        lines >> result.mean.off >> result.mean.allowed >> result.farthest.off >>
            result.farthest.allowed >> result.threads >> std::ws;
        for (std::string line; std::getline(lines, line);) {
            result.problems.push_back(line);
        }
        return result;
    }

private:
    // Of the processor, as others may use it too; and ten times as much by the clock, for threads
    // that wait for each other.
    static void limit_time(rlim_t seconds) {
        const rlimit limit{seconds, seconds};
        setrlimit(RLIMIT_CPU, &limit);
        alarm(static_cast<unsigned>(10 * seconds));
    }

    static void write_result(const Values& values, double fineness, int end) {
        Findings findings;
        try {
            findings = try_row(row_of(values), fineness);
        } catch (const std::exception& error) {
            findings.problems.push_back(std::string("throws: ") + error.what());
        }
        std::ostringstream text;
        text << findings.mean.off << ' ' << findings.mean.allowed << ' ' << findings.farthest.off
             << ' ' << findings.farthest.allowed << ' ' << findings.threads << '\n';
        for (const std::string& problem : findings.problems) {
            text << problem << '\n';
        }
        const std::string words = text.str();
        if (write(end, words.data(), words.size()) < 0) {
            _exit(1);
        }
    }

    pid_t id_ = -1;
    int end_ = -1;
};

// What fails, without its numbers.
std::string kind_of(const Result& result) {
    std::string kind = result.problems.empty() ? "" : result.problems.front();
    std::erase_if(kind, [](char c) { return c >= '0' && c <= '9'; });
    return kind;
}

// Features are switched off one by one while the row still fails in the same way.
Values cut_down(Values values, const std::string& kind, const Settings& settings) {
    for (bool is_smaller = true; is_smaller;) {
        is_smaller = false;
        for (std::size_t i = 0; i < feature_count; ++i) {
            Values plainer = values;
            plainer[i] = 0;
            if (values[i] != 0 && nonsense_in(plainer).empty() &&
                kind_of(Child(plainer, settings).wait()) == kind) {
                values = plainer;
                is_smaller = true;
            }
        }
    }
    return values;
}

void tell(const Values& values, const Result& result, double fineness) {
    for (const std::string& problem : result.problems) {
        std::cout << "  " << problem << '\n';
    }
    std::cout << "  dsc_combinations --row '" << words_of(values) << "'";
    if (fineness != 1) {
        std::cout << " --fineness " << fineness;
    }
    std::cout << '\n' << std::flush;
}

int run_one(const Settings& settings) {
    const Values values = values_of(settings.row);
    if (const std::string_view why = nonsense_in(values); !why.empty()) {
        std::cout << "makes no sense: " << why << '\n';
        return 2;
    }
    const Result result = Child(values, settings).wait();
    std::cout << "off by " << result.mean.off << " edge lengths, allowed " << result.mean.allowed
              << "; a vertex by " << result.farthest.off << ", allowed " << result.farthest.allowed
              << "; " << result.seconds << " s\n";
    for (const std::string& problem : result.problems) {
        std::cout << "  " << problem << '\n';
    }
    return result.problems.empty() ? 0 : 1;
}

std::size_t run_rows(const std::vector<Values>& rows, const Settings& settings) {
    std::size_t failed = 0;
    std::size_t in_threads = 0;
    for (std::size_t from = 0; from < rows.size(); from += settings.jobs) {
        std::vector<Child> children;
        const std::size_t to = std::min(rows.size(), from + settings.jobs);
        for (std::size_t i = from; i < to; ++i) {
            children.emplace_back(rows[i], settings);
        }
        for (std::size_t i = from; i < to; ++i) {
            const Result result = children[i - from].wait();
            if (settings.lists) {
                std::cout << result.mean.off << ' ' << result.mean.allowed << ' '
                          << result.farthest.off << ' ' << result.farthest.allowed << ' '
                          << result.seconds << ' ' << (result.problems.empty() ? "holds" : "FAILS")
                          << ' ' << words_of(rows[i]) << '\n';
            }
            in_threads += result.threads > 1 ? 1 : 0;
            if (result.problems.empty()) {
                continue;
            }
            ++failed;
            std::cout << "a row fails:\n";
            tell(rows[i], result, settings.fineness);
            if (settings.cuts_down) {
                const Values few = cut_down(rows[i], kind_of(result), settings);
                if (few != rows[i]) {
                    std::cout << "  cut down:\n";
                    tell(few, Child(few, settings).wait(), settings.fineness);
                }
            }
        }
    }
    std::cout << in_threads << " rows in two threads and more\n";
    return failed;
}

std::size_t expect_refusals() {
    std::size_t failed = 0;
    for (const std::string_view words : refused_rows()) {
        if (refusal_of(row_of(values_of(words))).empty()) {
            ++failed;
            std::cout << "is not refused: " << words << '\n';
        }
    }
    return failed;
}

int run(const Settings& settings) {
    if (!settings.row.empty()) {
        return run_one(settings);
    }
    const Cover cover = cover_features(settings.strength, settings.seed, settings.most_rows);
    std::vector<Values> rows;
    std::ranges::transform(found_rows(), std::back_inserter(rows), values_of);
    for (const auto& row : cover.rows) {
        Values& values = rows.emplace_back();
        std::copy_n(row.begin(), feature_count, values.begin());
    }
    const std::size_t failed = run_rows(rows, settings) + expect_refusals();
    std::cout << cover.covered << " of " << cover.combinations << " combinations of "
              << settings.strength << " values in " << rows.size() << " rows; " << cover.senseless
              << " make no sense; " << failed << " rows fail\n";
    return failed == 0 ? 0 : 1;
}

} // namespace
} // namespace dsc::combinations

int main(int argc, char** argv) {
    dsc::combinations::Settings settings;
    CLI::App app(
        "Runs combinations of features whose answers are known from their parts: exact "
        "shapes, what is conserved, other numbers of threads, runs without an "
        "interruption. A row that fails is cut down to the features that it needs for that.");
    app.add_option("--row", settings.row, "only this row, e.g. 'motion=turn way=cells'");
    app.add_option("--strength", settings.strength, "so many features at a time")
        ->check(CLI::Range(1, 4));
    app.add_option("--seed", settings.seed, "another one makes other rows");
    app.add_option("--most-rows", settings.most_rows, "stop after these");
    app.add_option("--jobs", settings.jobs, "rows at a time")->check(CLI::Range(1, 64));
    app.add_option("--limit", settings.limit_s,
                   "seconds of the processor after which a row counts as hanging");
    app.add_option("--fineness", settings.fineness, "divides the length of edges")
        ->check(CLI::Range(0.5, 16.0));
    app.add_flag("--list", settings.lists, "print each row with its distance and time");
    app.add_flag("!--keep-whole", settings.cuts_down, "do not cut down what fails");
    CLI11_PARSE(app, argc, argv);
    try {
        return dsc::combinations::run(settings);
    } catch (const dsc::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
