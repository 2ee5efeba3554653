// SPDX-License-Identifier: MIT
// What the tests of copied submeshes share.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/copied/copy_executor.h"

#include <algorithm>
#include <memory>

namespace dsc::test {

inline Simulation<double>
in_copies(Complex<double>& complex, const Options<double>& options, const CopyOptions& copy,
          const Algorithm<double>& algorithm = default_algorithm<double>()) {
    return Simulation<double>(
        complex, options,
        std::make_unique<CopyExecutor<double>>(complex, options, algorithm, copy));
}

inline Velocity<double> everywhere(double x, double y) {
    return [=](std::span<const Point<double>>, double, std::span<Point<double>> velocities) {
        std::fill(velocities.begin(), velocities.end(), Point<double>(x, y));
    };
}

} // namespace dsc::test
