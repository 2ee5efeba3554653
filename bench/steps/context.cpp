// SPDX-License-Identifier: MIT
#include "steps/context.h"

#include "scenes/output/machine.h"

#include <benchmark/benchmark.h>
#include <omp.h>

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace dsc::bench {

namespace {

/// Busy seconds since the start of the machine, summed over its cores, and those of this process.
struct BusyTime {
    double all = 0;
    double own = 0;
    std::chrono::steady_clock::time_point when;
};

BusyTime busy_so_far() {
    BusyTime time;
    time.when = std::chrono::steady_clock::now();
    // "cpu", then user, nice, system, idle, waiting, interrupts, soft interrupts, and time stolen
    // by other virtual machines.
    std::ifstream stat("/proc/stat");
    std::string cpu;
    stat >> cpu;
    double ticks = 0;
    for (int i = 0; i < 8 && stat >> ticks; ++i) {
        const bool at_rest = i == 3 || i == 4;
        time.all += at_rest ? 0 : ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
    }
    timespec own{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
    time.own = static_cast<double>(own.tv_sec) + 1e-9 * static_cast<double>(own.tv_nsec);
    return time;
}

} // namespace

std::uint32_t core_count() { return static_cast<std::uint32_t>(omp_get_num_procs()); }

std::vector<std::uint32_t> thread_counts() {
    std::vector<std::uint32_t> counts;
    for (std::uint32_t n = 1; n < core_count(); n *= 2) {
        counts.push_back(n);
    }
    counts.push_back(core_count());
    return counts;
}

double other_load() {
    // The kernel counts in hundredths of a second: shorter spans are too inaccurate.
    static constexpr auto shortest = std::chrono::milliseconds(300);
    static BusyTime before = [] {
        const BusyTime first = busy_so_far();
        std::this_thread::sleep_for(shortest);
        return first;
    }();
    static double load = 0;
    const BusyTime now = busy_so_far();
    const std::chrono::duration<double> span = now.when - before.when;
    if (span >= shortest) {
        load = std::max(0.0, (now.all - before.all - now.own + before.own) / span.count());
        before = now;
    }
    return load;
}

void add_context() {
    char load[32];
    std::snprintf(load, sizeof load, "%.2f", other_load());
    benchmark::AddCustomContext("dsc_machine", scenes::machine());
    benchmark::AddCustomContext("dsc_commit", scenes::commit());
    benchmark::AddCustomContext("dsc_cores", std::to_string(core_count()));
    benchmark::AddCustomContext("dsc_compiler", scenes::compiler());
    benchmark::AddCustomContext("dsc_build_type", DSC_BUILD_TYPE);
    benchmark::AddCustomContext("dsc_native", DSC_NATIVE_BUILD);
    benchmark::AddCustomContext("dsc_load", load);
    const auto set_to = [](const char* name, const char* otherwise) {
        const char* value = std::getenv(name); // NOLINT: no thread sets variables
        return std::string(value != nullptr ? value : otherwise);
    };
    benchmark::AddCustomContext("dsc_clock", "wall time by a steady clock");
    benchmark::AddCustomContext("dsc_binding", "OMP_PROC_BIND " + set_to("OMP_PROC_BIND", "unset") +
                                                   ", OMP_WAIT_POLICY " +
                                                   set_to("OMP_WAIT_POLICY", "unset"));
}

} // namespace dsc::bench
