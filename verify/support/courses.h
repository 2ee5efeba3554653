// SPDX-License-Identifier: MIT
// Common parts of the tests of edits and options: a disc in a swirl, run sequentially and with each
// division.
#pragma once

#include "support/random/scene.h"
#include "support/simulation_testing.h"

#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "thesis/divisions.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace dsc::test {

inline constexpr double disc_h = 0.03;

// The way to run; no division means sequentially.
struct Course {
    const char* name;
    const Division* division = nullptr;
    std::uint32_t threads = 1;
};

inline std::unique_ptr<Simulation<double>>
make_simulation(Complex<double>& complex, const Options<double>& options, const Course& way) {
    if (way.division == nullptr) {
        return std::make_unique<Simulation<double>>(complex, options);
    }
    return std::make_unique<Simulation<double>>(
        complex, options,
        Parallel{.threads = way.threads, .division = way.division, .always_all_threads = true});
}

inline const Velocity<double> swirl = pointwise([](const Point<double>& p) {
    const double x = std::numbers::pi * p.x();
    const double y = std::numbers::pi * p.y();
    return Point<double>(std::pow(std::sin(x), 2) * std::sin(2 * y),
                         -std::pow(std::sin(y), 2) * std::sin(2 * x));
});

inline const Velocity<double> still = constant<double>(0, 0);

inline Complex<double> disc() { return disc_complex<double>(disc_h, {0.5, 0.7}, 0.2); }

inline const std::vector<Course> all_courses{{"sequential", {}},
                                             {"active", &active_division},
                                             {"blocks", &blocks_division},
                                             {"cells", &cells_division},
                                             {"copy", &copy_division}};

inline const auto course_name = [](const auto& one) { return std::string(one.param.name); };

} // namespace dsc::test
