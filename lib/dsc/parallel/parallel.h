// SPDX-License-Identifier: MIT
// Parallel DSC in one line: `Simulation simulation(complex, options, Parallel{.threads = 2})`.
#pragma once

#include "dsc/base/names.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace dsc {

struct Division;                      // parallel/executors.h
extern const Division cells_division; ///< submeshes that follow the interface

/// Which thread runs which task.
enum class Assignment : std::uint8_t {
    fixed, ///< each thread always has the same share of each colour: static assignment
    queue, ///< the same, but an idle thread takes over tasks that nobody has begun: the last task
           ///< of another thread only if that thread is late
};

inline constexpr std::array assignment_names{
    Named{Assignment::fixed, "fixed"},
    Named{Assignment::queue, "queue"},
};

[[nodiscard]] constexpr std::string_view to_string(Assignment assignment) {
    return name_in(assignment_names, assignment);
}

/// The result depends on the division and the number of submeshes, and on nothing else here.
struct Parallel {
    /// Largest number of threads, 1 to 1024; fewer are used when more would not be faster.
    std::uint32_t threads = 1;
    const Division* division = &cells_division; ///< how the mesh is divided; outlives the executor
    std::uint32_t submeshes = 0;                ///< 0: the division's own choice
    bool always_all_threads = false;           ///< uses all threads, even if fewer would be as fast
    Assignment assignment = Assignment::queue; ///< which thread runs which submesh
    bool profile = false;                      ///< measure times: see `SubmeshView`
};

} // namespace dsc
