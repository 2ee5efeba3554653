// SPDX-License-Identifier: MIT
// The context of a result: machine, commit, compiler, load.
#pragma once

#include <cstdint>
#include <vector>

namespace dsc::bench {

/// The number of cores that this process may use, regardless of bound threads.
[[nodiscard]] std::uint32_t core_count();

/// 1, 2, 4, ... and the number of cores.
[[nodiscard]] std::vector<std::uint32_t> thread_counts();

/// The number of cores kept busy by other programs since the last call, or in the last span of at
/// least 0.3 s. Unlike the load average, it drops as soon as a build has ended. Not thread-safe.
[[nodiscard]] double other_load();

/// Adds the dsc_* keys to the context of Google Benchmark's reports. Its own key
/// "library_build_type" describes the installed libbenchmark, not this program.
void add_context();

} // namespace dsc::bench
