// SPDX-License-Identifier: MIT
// Memory in use (VmRSS) and its maximum (VmHWM) are in /proc/self/status; writing "5" to
// /proc/self/clear_refs resets the maximum (man 5 proc).
#include "steps/memory.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace dsc::bench {

namespace {

double status_mb(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == key) {
            double kib = 0;
            status >> kib;
            return kib * 1024e-6;
        }
    }
    return 0;
}

bool reset_peak() {
    std::ofstream clear("/proc/self/clear_refs");
    clear << "5" << std::flush;
    return clear.good();
}

} // namespace

PeakMemory::PeakMemory() : reset_(false), first_mb_(0) {
    malloc_trim(0);
    reset_ = reset_peak();
    first_mb_ = status_mb("VmRSS:");
}

double PeakMemory::mb() const {
    return reset_ ? status_mb("VmHWM:") : std::max(first_mb_, status_mb("VmRSS:"));
}

} // namespace dsc::bench
