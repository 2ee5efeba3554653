// SPDX-License-Identifier: MIT
// Replaces operator new, in programs linked with the source file of this header, by one that
// counts. Allocations by C and by the OpenMP runtime are not counted.
#pragma once

#include <cstdint>

namespace dsc::test {

/// The number of calls of operator new by any thread since the start of the program.
[[nodiscard]] std::uint64_t allocations_so_far();

} // namespace dsc::test
