// SPDX-License-Identifier: MIT
// Parallel DSC in one line: `Simulation simulation(complex, options, Parallel{.threads = 2})`.
#pragma once

#include <cstdint>

namespace dsc3 {

/// The result depends on the number of submeshes, and not on the number of threads.
struct Parallel {
    std::uint32_t threads = 1; ///< largest number of threads, 1 to 1024
    /// Into how many submeshes the mesh is divided at most: a power of two up to 64. 0: 8 where the
    /// interface is 60 edge lengths long or more, otherwise 4.
    std::uint32_t submeshes = 0;
};

} // namespace dsc3
