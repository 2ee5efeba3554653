// SPDX-License-Identifier: MIT
// The sequential method, or one division of the mesh into four submeshes on all threads.
#pragma once

#include "dsc/parallel/parallel.h"
#include "thesis/blocks.h"
#include "thesis/copy_executor.h"
#include "thesis/slabs.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsc::test {

/// None: sequential.
using Way = std::optional<Division>;

/// Those in submeshes of the mesh itself.
inline constexpr std::array in_place_divisions{fixed_division, counting_division, active_division,
                                               blocks_division, Division::cells};

/// All of these, and create and merge.
inline std::vector<Division> all_divisions() {
    std::vector<Division> all(in_place_divisions.begin(), in_place_divisions.end());
    all.push_back(copy_division);
    return all;
}

inline std::string name_of(const Way& way) {
    return way ? std::string((*way)->name) : "sequential";
}

/// Null for the sequential method: a simulation then makes its own.
inline std::unique_ptr<Executor<double>> executor_of(const Way& way, Complex<double>& complex,
                                                     const Options<double>& options) {
    if (!way) {
        return nullptr;
    }
    return make_executor(complex, options,
                         Parallel{.division = *way, .submeshes = 4, .always_all_threads = true});
}

} // namespace dsc::test
