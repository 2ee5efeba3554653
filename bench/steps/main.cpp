// SPDX-License-Identifier: MIT
// dsc_bench: Google Benchmark's flags, and nothing else. Exit code 0: done; 1: a benchmark was
// refused, because its answer is wrong; 2: bad usage, or nothing to run.
#include "context.h"
#include "refusal.h"
#include "suites.h"

#include <benchmark/benchmark.h>

#include <cstdio>

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (argc > 1) {
        std::fprintf(stderr,
                     "dsc_bench: unknown argument '%s'; allowed: the flags of Google Benchmark, "
                     "as --help lists them.\n",
                     argv[1]);
        return 2;
    }
    dsc::bench::add_context();
    dsc::bench::register_runs();
    dsc::bench::register_steps();
    dsc::bench::register_operations();
    dsc::bench::register_flows();
    dsc::bench::register_options();
    if (benchmark::RunSpecifiedBenchmarks() == 0) {
        std::fputs("dsc_bench: --benchmark_filter leaves no benchmark; --benchmark_list_tests "
                   "names all of them.\n",
                   stderr);
        return 2;
    }
    benchmark::Shutdown();
    if (dsc::bench::refusals() > 0) {
        std::fprintf(stderr, "dsc_bench: %zu measurements were refused for a wrong answer.\n",
                     dsc::bench::refusals());
        return 1;
    }
    return 0;
}
