// SPDX-License-Identifier: MIT
// The ways to run a simulation: sequentially, or with one division of the mesh into four submeshes,
// on one thread.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "thesis/divisions.h"

#include <memory>
#include <string>

namespace dsc::test {

/// Null: sequential.
using Way = const Division*;

inline std::string name_of(Way way) { return way ? std::string(way->name) : "sequential"; }

/// Null for the sequential method: a simulation then makes its own.
inline std::unique_ptr<Executor<double>> executor_of(Way way, Complex<double>& complex,
                                                     const Options<double>& options) {
    if (!way) {
        return nullptr;
    }
    return make_executor(complex, options, Parallel{.division = way, .submeshes = 4});
}

} // namespace dsc::test
