// SPDX-License-Identifier: MIT
#include "scenes/run/clock.h"

#include <sys/resource.h>

#include <ctime>

namespace dsc::scenes {

namespace {

double seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

} // namespace

Stopwatch::Stopwatch()
    : wall_begin_(seconds(CLOCK_MONOTONIC)), cpu_begin_(seconds(CLOCK_PROCESS_CPUTIME_ID)) {}

double Stopwatch::wall() const { return seconds(CLOCK_MONOTONIC) - wall_begin_; }
double Stopwatch::cpu() const { return seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_begin_; }

double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024e-6;
}

} // namespace dsc::scenes
