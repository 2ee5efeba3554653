// SPDX-License-Identifier: MIT
// The counters that all modelled rows have.
#pragma once

#include "steps/model.h"

#include <benchmark/benchmark.h>

namespace dsc::bench {

/// `start_s`, `fork_join_s`: the seconds of a section's start with work and without; `steps`: those
/// of the modelled run.
inline void count_model(benchmark::State& state, const ModelTimes& times, double start_s,
                        double fork_join_s, double steps) {
    state.SetIterationTime(times.seconds);
    const auto per_step = [&](double seconds) { return seconds * 1e6 / steps; };
    auto& counters = state.counters;
    counters["us_per_step"] = per_step(times.seconds);
    counters["modelled"] = 1;
    counters["serial_share"] = times.serial_share;
    counters["busy_share"] = times.busy_share;
    counters["fork_join_us"] = fork_join_s * 1e6;
    counters["section_start_us"] = start_s * 1e6;
    // The time of one worker for everything.
    counters["us_serial"] = per_step(times.serial);
    counters["us_tasks"] = per_step(times.tasks);
    counters["us_starts"] = per_step(times.starts);
}

} // namespace dsc::bench
