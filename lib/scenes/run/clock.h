// SPDX-License-Identifier: MIT
// Wall time, CPU time of all threads, and peak memory of this process.
#pragma once

#include <sys/resource.h>

#include <ctime>

namespace dsc::scenes {

/// Starts at construction.
class Stopwatch {
public:
    [[nodiscard]] double wall() const { return seconds(CLOCK_MONOTONIC) - wall_begin_; }
    /// CPU seconds of all threads.
    [[nodiscard]] double cpu() const { return seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_begin_; }

private:
    static double seconds(clockid_t clock) {
        timespec now{};
        clock_gettime(clock, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

    double wall_begin_ = seconds(CLOCK_MONOTONIC);
    double cpu_begin_ = seconds(CLOCK_PROCESS_CPUTIME_ID);
};

/// Peak memory in 10^6 bytes.
[[nodiscard]] inline double peak_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024e-6;
}

} // namespace dsc::scenes
