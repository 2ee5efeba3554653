// SPDX-License-Identifier: MIT
// Parallel DSC in one line: `Simulation simulation(complex, options, Parallel{.threads = 2})`.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/in_place/schedule.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace dsc {

/// How the mesh is divided into submeshes. `divisions` says what each of them is.
enum class Division : std::uint8_t { fixed, counting, active, blocks, cells, copy };

/// The result depends on the division, the number of submeshes and the direction, and on nothing
/// else here.
struct Parallel {
    std::uint32_t threads = 1;
    Division division = Division::cells;
    std::uint32_t submeshes = 0;     ///< 0: the division's own choice
    double degrees = 0;              ///< slabs are cut across this direction, from the x axis
    bool follow_shape = false;       ///< slabs are cut across the direction of the shape instead
    bool always_all_threads = false; ///< also where there is too little to do for them
    Assignment assignment = Assignment::queue;
    bool profile = false; ///< keep an account of times (in_place/step_profile.h)
};

/// Makes an executor for either precision.
template <class Real>
using MakeExecutor = std::unique_ptr<Executor<Real>> (*)(Complex<Real>& complex,
                                                         const Options<Real>& options,
                                                         const Parallel& parallel,
                                                         Algorithm<Real> algorithm);

/// All that there is to know of a division.
struct DivisionEntry {
    Division division;
    std::string_view name;
    std::string_view description;
    std::uint32_t submeshes; ///< where no number is asked for; 0: chosen as it runs
    MakeExecutor<double> in_double;
    MakeExecutor<float> in_float;
};

/// One entry for each, in their order.
[[nodiscard]] const std::vector<DivisionEntry>& divisions();

/// The submeshes that this makes: the number asked for, or the division's own; 0: chosen as it
/// runs.
[[nodiscard]] std::uint32_t submeshes_of(const Parallel& parallel);

/// The executor that runs so, for an algorithm of one's own. Throws InputError where the options
/// make no sense together.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              Algorithm<Real> algorithm = default_algorithm<Real>());

} // namespace dsc
