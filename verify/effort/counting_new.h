// SPDX-License-Identifier: MIT
// Replaces operator new, of whole programs that are linked with the source file of this header, by
// one that counts. What C allocates, and the OpenMP runtime for its threads, is not counted.
#pragma once

#include <cstdint>

namespace dsc::test {

/// Calls of operator new by any thread, since the program began.
[[nodiscard]] std::uint64_t allocations_so_far();

} // namespace dsc::test
