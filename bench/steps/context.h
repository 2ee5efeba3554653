// SPDX-License-Identifier: MIT
// What a result must say about its run: machine, commit, compiler, load.
#pragma once

#include <cstdint>

namespace dsc::bench {

/// Cores that this process may use; binding threads to cores does not change it.
[[nodiscard]] std::uint32_t core_count();

/// Processes that wanted to run, on average over the last minute; 0 where it cannot be known.
[[nodiscard]] double load_average();

/// Adds the dsc_* keys to the context of Google Benchmark's reports. Its own "library_build_type"
/// is that of the installed libbenchmark and says nothing about us.
void add_context();

} // namespace dsc::bench
