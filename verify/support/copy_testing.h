// SPDX-License-Identifier: MIT
// Common parts of the tests of copied submeshes.
#pragma once

#include "support/simulation_testing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/passes/algorithm.h"
#include "thesis/copies/copy_executor.h"

#include <memory>

namespace dsc::test {

inline Simulation<double>
in_copies(Complex<double>& complex, const Options<double>& options, const CopyOptions& copy,
          const Algorithm<double>& algorithm = default_algorithm<double>()) {
    return Simulation<double>(
        complex, options,
        std::make_unique<CopyExecutor<double>>(complex, options, algorithm, copy));
}

} // namespace dsc::test
