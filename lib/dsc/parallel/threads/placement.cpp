// SPDX-License-Identifier: MIT
#include "dsc/parallel/threads/placement.h"

#include <omp.h>

#include <cstdlib>

#if defined(__linux__)
#include <sched.h>
#endif

namespace dsc {

#if defined(__linux__)

int current_core() { return sched_getcpu(); }

void leave_core(int core, unsigned number) {
    cpu_set_t allowed;
    if (core < 0 || core >= CPU_SETSIZE || sched_getaffinity(0, sizeof allowed, &allowed) != 0) {
        return;
    }
    cpu_set_t others = allowed;
    CPU_CLR(static_cast<unsigned>(core), &others);
    const int count = CPU_COUNT(&others);
    if (count == 0) {
        return;
    }
    unsigned left = number % static_cast<unsigned>(count);
    for (unsigned other = 0; other < CPU_SETSIZE; ++other) {
        if (CPU_ISSET(other, &others) && left-- == 0) {
            cpu_set_t one;
            CPU_ZERO(&one);
            CPU_SET(other, &one);
            if (sched_setaffinity(0, sizeof one, &one) == 0) {
                sched_setaffinity(0, sizeof allowed, &allowed);
            }
            return;
        }
    }
}

void use_cores(const std::vector<int>& cores) {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    for (const int core : cores) {
        if (core >= 0 && core < CPU_SETSIZE) {
            CPU_SET(static_cast<unsigned>(core), &allowed);
        }
    }
    if (CPU_COUNT(&allowed) > 0) {
        sched_setaffinity(0, sizeof allowed, &allowed);
    }
}

#else

int current_core() { return -1; }
void leave_core(int /*core*/, unsigned /*number*/) {}
void use_cores(const std::vector<int>& /*cores*/) {}

#endif

std::vector<int> cores_of_openmp() {
    std::vector<int> cores;
    // The variable first: to ask OpenMP is to start it.
    if (std::getenv("OMP_PROC_BIND") == nullptr || // NOLINT: nobody here sets variables
        omp_get_proc_bind() == omp_proc_bind_false) {
        return cores;
    }
    for (int place = 0; place < omp_get_num_places(); ++place) {
        std::vector<int> some(static_cast<std::size_t>(omp_get_place_num_procs(place)));
        omp_get_place_proc_ids(place, some.data());
        cores.insert(cores.end(), some.begin(), some.end());
    }
    return cores;
}

} // namespace dsc
