// SPDX-License-Identifier: MIT
// Wrong results are not timed: a benchmark with a wrong result is reported without a time, and the
// exit code of the program says so.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <exception>
#include <string>

namespace dsc::bench {

/// Ends a benchmark with an error instead of a time.
void refuse(benchmark::State& state, const std::string& reason);

/// The number of refused benchmarks so far.
[[nodiscard]] std::size_t refusals();

/// Runs the body; an exception is a refusal.
template <class Body>
void guarded(benchmark::State& state, Body body) {
    try {
        body(state);
    } catch (const std::exception& error) {
        refuse(state, error.what());
    }
}

/// A row that measures its own time; an exception of its body is a refusal.
template <class Body>
benchmark::internal::Benchmark* add_row(const std::string& name, Body body) {
    return benchmark::RegisterBenchmark(name.c_str(),
                                        [body](benchmark::State& state) { guarded(state, body); })
        ->UseManualTime();
}

/// The same for a row with a single iteration of some milliseconds.
template <class Body>
void add_long_row(const std::string& name, Body body) {
    add_row(name, body)->Iterations(1)->Unit(benchmark::kMillisecond);
}

} // namespace dsc::bench
