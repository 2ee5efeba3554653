// SPDX-License-Identifier: MIT
#include "dsc/parallel/threads/placement.h"

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

#else

int current_core() { return -1; }
void leave_core(int /*core*/, unsigned /*number*/) {}

#endif

} // namespace dsc
