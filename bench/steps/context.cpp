// SPDX-License-Identifier: MIT
#include "context.h"

#include "scenes/output/machine.h"

#include <benchmark/benchmark.h>
#include <omp.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace dsc::bench {

namespace {

std::string compiler() {
#if defined(__clang__)
    return "clang++ " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

} // namespace

std::uint32_t core_count() { return static_cast<std::uint32_t>(omp_get_num_procs()); }

double load_average() {
    double load = 0;
    return getloadavg(&load, 1) == 1 ? load : 0.0;
}

void add_context() {
    char load[32];
    std::snprintf(load, sizeof load, "%.2f", load_average());
    benchmark::AddCustomContext("dsc_machine", scenes::machine());
    benchmark::AddCustomContext("dsc_commit", scenes::commit());
    benchmark::AddCustomContext("dsc_cores", std::to_string(core_count()));
    benchmark::AddCustomContext("dsc_compiler", compiler());
    benchmark::AddCustomContext("dsc_build_type", DSC_BUILD_TYPE);
    benchmark::AddCustomContext("dsc_native", DSC_NATIVE_BUILD);
    benchmark::AddCustomContext("dsc_load", load);
}

} // namespace dsc::bench
