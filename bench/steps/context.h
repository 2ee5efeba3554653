// SPDX-License-Identifier: MIT
// What a result must say about its run: machine, commit, compiler, load.
#pragma once

#include <cstdint>
#include <vector>

namespace dsc::bench {

/// Cores that this process may use; binding threads to cores does not change it.
[[nodiscard]] std::uint32_t core_count();

/// 1, 2, 4, ... and the number of cores.
[[nodiscard]] std::vector<std::uint32_t> thread_counts();

/// Cores that other programs keep busy: since the last call, or of the last span of at least 0.3 s.
/// Unlike the load average, it has forgotten a build as soon as that has ended. Not thread safe.
[[nodiscard]] double other_load();

/// Adds the dsc_* keys to the context of Google Benchmark's reports. Its own "library_build_type"
/// is that of the installed libbenchmark and says nothing about us.
void add_context();

} // namespace dsc::bench
