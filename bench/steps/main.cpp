// SPDX-License-Identifier: MIT
// dsc_bench: makes the measurements of a suite. Exit code 0: done; 1: a benchmark was not timed
// because its answer is wrong; 2: bad usage, or nothing to run.
#include "steps/context.h"
#include "steps/refusal.h"
#include "steps/suites.h"

#include "dsc/base/error.h"
#include "scenes/command_line/standard_output.h"
#include "scenes/file/text_file.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace dsc::bench {

namespace {

void print_help() {
    std::fputs("usage: dsc_bench [--suite FILE] [Google Benchmark options]\n"
               " --suite FILE the suite, as TOML; default: " DSC_DEFAULT_SUITE "\n"
               "A suite of your own, of which plots/speedup.py draws S(n) and U(n):\n"
               "  [[case]]\n"
               "  scene = \"swirl\"             # or the path of a scene file, from the suite on\n"
               "  measure = \"run\"             # whole runs; or step, model, option\n"
               "  h = [0.02, 0.01]            # or triangles = [28000]; else the scene's own h\n"
               "  strategies = [\"sequential\", \"cells\", \"active\"]\n"
               "  threads = [1, 2]            # else 1, 2, 4, ... and all cores\n"
               "  set = { insertion = \"linear\" }\n"
               "bench/steps/suite.h lists all keys.\n"
               "Exit code: 0 done, 1 a wrong answer was not timed, 2 bad usage.\n\n",
               stdout);
    benchmark::PrintDefaultHelp();
}

// The suite from the arguments that Google Benchmark has left.
std::string suite_file(int argc, char** argv) {
    std::optional<std::string> file;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const std::string option = "--suite";
        const bool is_alone = argument == option;
        if (!is_alone && !argument.starts_with(option + '=')) {
            throw InputError({.what = "unknown argument",
                              .where = "command line",
                              .value = "'" + argument + "'",
                              .allowed = "--suite FILE, and the flags of Google Benchmark, as "
                                         "--help lists them"});
        }
        if (file || (is_alone && i + 1 == argc)) {
            throw InputError({.what = "exactly one suite is needed",
                              .where = option,
                              .value = file ? "two" : "no file",
                              .allowed = "--suite FILE, once"});
        }
        file = is_alone ? std::string(argv[++i]) : argument.substr(option.size() + 1);
    }
    return file.value_or(DSC_DEFAULT_SUITE);
}

// The file of Google Benchmark's option --benchmark_out.
std::vector<scenes::NamedFile> result_file(int argc, char** argv) {
    const std::string option = "--benchmark_out";
    std::vector<scenes::NamedFile> files;
    for (int i = 1; i < argc; ++i) {
        if (const std::string argument = argv[i]; argument.starts_with(option + '=')) {
            files.assign(1, {option, argument.substr(option.size() + 1)});
        }
    }
    return files;
}

void register_all(const Suite& suite) {
    for (const Row& row : suite.rows) {
        row.measure == Measure::run ? register_run(row) : register_step(row);
    }
    std::ranges::for_each(suite.space_rows, register_space_run);
    std::ranges::for_each(suite.comparisons, register_comparison);
    for (const std::string& name : suite.also) {
        (name == "operation" ? register_operations
         : name == "kernel"  ? register_kernels
         : name == "flow"    ? register_flows
                             : register_space)();
    }
}

int run(int argc, char** argv) {
    const std::vector<scenes::NamedFile> results = result_file(argc, argv);
    benchmark::Initialize(&argc, argv, print_help);
    const std::string file = suite_file(argc, argv);
    const Suite suite = read_suite(file);
    scenes::check_outputs(results, {{"--suite", file}});
    add_context();
    register_all(suite);
    if (suite.has_results && suite.rows.empty() && suite.space_rows.empty() &&
        suite.comparisons.empty() && suite.also.empty()) {
        std::fputs("dsc_bench: this suite has no timed rows; bench/Snakefile makes its results.\n",
                   stderr);
        return 0;
    }
    if (benchmark::RunSpecifiedBenchmarks() == 0) {
        std::fputs("dsc_bench: no benchmark matches --benchmark_filter; --benchmark_list_tests "
                   "lists all.\n",
                   stderr);
        return 2;
    }
    benchmark::Shutdown();
    if (refusals() > 0) {
        std::fprintf(stderr, "dsc_bench: %zu measurements were refused for a wrong answer.\n",
                     refusals());
        return 1;
    }
    return 0;
}

} // namespace

} // namespace dsc::bench

int main(int argc, char** argv) {
    try {
        return dsc::scenes::with_output_written("dsc_bench", dsc::bench::run(argc, argv));
    } catch (const dsc::InputError& error) {
        std::fprintf(stderr, "dsc_bench: %s.\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dsc_bench: %s\n", error.what());
        return 1;
    }
}
