// SPDX-License-Identifier: MIT
// Parallel DSC in one line: `Simulation simulation(complex, options, Parallel{.threads = 2})`.
#pragma once

#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/in_place/schedule.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace dsc {

/// How the mesh is divided into submeshes. `divisions` describes each way.
enum class Division : std::uint8_t { fixed, counting, active, blocks, cells, copy };

/// The result depends on the division, the number of submeshes and the direction, and on nothing
/// else here.
struct Parallel {
    /// 1 to 1024; fewer are used where there is too little to do, or where that takes no longer.
    std::uint32_t threads = 1;
    Division division = Division::cells; ///< how the mesh is divided
    std::uint32_t submeshes = 0;         ///< 0: the division's own choice
    double degrees = 0;                  ///< slabs are cut across this direction, from the x axis
    bool follow_shape = false;       ///< slabs are cut across the direction of the shape instead
    bool always_all_threads = false; ///< also if there is too little to do for them, or no gain
    /// Microseconds that threads wait awake between two steps before they sleep; nothing:
    /// `default_awake_time()`.
    std::optional<std::uint32_t> awake_us = std::nullopt;
    Assignment assignment = Assignment::queue; ///< which thread runs which submesh
    bool profile = false;                      ///< measure times (in_place/step_profile.h)
};

/// Makes an executor for either precision.
template <class Real>
using MakeExecutor = std::unique_ptr<Executor<Real>> (*)(Complex<Real>& complex,
                                                         const Options<Real>& options,
                                                         const Parallel& parallel,
                                                         Algorithm<Real> algorithm);

/// The properties of a division.
struct DivisionEntry {
    Division division;              ///< which one it is
    std::string_view name;          ///< on command lines and in files
    std::string_view description;   ///< one sentence, for help texts
    std::uint32_t submeshes;        ///< if no number is asked for; 0: chosen during the run
    MakeExecutor<double> in_double; ///< makes its executor
    MakeExecutor<float> in_float;   ///< makes its executor
};

/// One entry for each division, in their order.
[[nodiscard]] const std::vector<DivisionEntry>& divisions();

/// The number of submeshes that results: the number asked for, or the division's default; 0: chosen
/// during the run.
[[nodiscard]] std::uint32_t submeshes_of(const Parallel& parallel);

/// The executor for these options, for an algorithm of your own. Throws InputError if the options
/// make no sense together, or while a simulation of the complex lives.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              Algorithm<Real> algorithm = default_algorithm<Real>());

} // namespace dsc
