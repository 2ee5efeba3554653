// SPDX-License-Identifier: MIT
// How the mesh is divided into submeshes, and the executors that run an algorithm in them.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/parallel/parallel.h"
#include "dsc/parallel/partition/partition.h"
#include "dsc/passes/algorithm.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <type_traits>

namespace dsc {

/// Makes an executor for either precision.
template <class Real>
using MakeExecutor = std::unique_ptr<Executor<Real>> (*)(Complex<Real>& complex,
                                                         const Options<Real>& options,
                                                         const Parallel& parallel,
                                                         Algorithm<Real> algorithm);

/// How the mesh is divided into submeshes: in the library's way, in one of a module, or in one of
/// the application's own.
struct Division {
    std::string_view name;          ///< on command lines and in files
    std::string_view description;   ///< one sentence, for help texts
    std::uint32_t submeshes;        ///< if no number is asked for; 0: chosen during the run
    MakeExecutor<double> in_double; ///< makes its executor
    MakeExecutor<float> in_float;   ///< makes its executor
};

/// The number of submeshes that results: the number asked for, or the division's default; 0: chosen
/// during the run.
[[nodiscard]] std::uint32_t submeshes_of(const Parallel& parallel);

/// The executor for these options, for an algorithm of your own. Throws InputError if the options
/// make no sense together, or while a simulation of the complex lives.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              Algorithm<Real> algorithm = default_algorithm<Real>());
/// The same with a partitioner of your own, which takes the place of `parallel.division`.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              std::type_identity_t<std::unique_ptr<Partitioner<Real>>> partitioner,
              Algorithm<Real> algorithm = default_algorithm<Real>());

} // namespace dsc
