// SPDX-License-Identifier: MIT
// A program of which several processes run with the same command line: the first one speaks for
// all, and all end together.
#pragma once

#include "dsc/parallel/ranks/ranks.h"

#include <exception>
#include <iostream>

namespace dsc::scenes {

/// Whether this process prints and writes files. Null: it is the only one.
inline bool leads(const Ranks* ranks) { return ranks == nullptr || ranks->rank() == 0; }

/// From now on the others print nothing.
inline void silence_others(const Ranks* ranks) {
    if (!leads(ranks)) {
        std::cout.setstate(std::ios::failbit);
        std::cerr.setstate(std::ios::failbit);
    }
}

/// Calls `run` and returns its exit code when all processes have done so. What ends it in one of
/// them is told to the others, and thrown in all.
template <class Run>
int end_together(Ranks* ranks, Run run) {
    if (ranks == nullptr) {
        return run();
    }
    try {
        const int code = run();
        ranks->wait_for_all();
        return code;
    } catch (...) {
        ranks->leave(std::current_exception());
        throw;
    }
}

} // namespace dsc::scenes
