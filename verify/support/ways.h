// SPDX-License-Identifier: MIT
// The sequential method, or one division of the mesh into four submeshes on all threads.
#pragma once

#include "dsc/parallel/parallel.h"
#include "thesis/copy_executor.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dsc::test {

/// None: sequential.
using Way = std::optional<Division>;

/// Those of the library, and create and merge.
inline std::vector<Division> all_divisions() {
    std::vector<Division> all(divisions().begin(), divisions().end());
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
