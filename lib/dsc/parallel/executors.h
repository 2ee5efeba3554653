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

/// How the mesh is divided into submeshes: by the library, by a module or by the application.
struct Division {
    std::string_view name;          ///< on command lines and in files
    std::string_view description;   ///< one sentence, for help texts
    std::uint32_t submeshes;        ///< the default; 0: chosen during the run
    MakeExecutor<double> in_double; ///< makes its executor
    MakeExecutor<float> in_float;   ///< makes its executor
};

/// The number of submeshes: the one requested, or the division's default; 0: chosen during the run.
[[nodiscard]] std::uint32_t submeshes_of(const Parallel& parallel);

/// Makes the executor for these options, for a custom algorithm. Throws InputError if an option is
/// out of range, or while a simulation of the complex exists.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              Algorithm<Real> algorithm = default_algorithm<Real>());
/// The same with a custom partitioner, which replaces `parallel.division`.
template <class Real>
[[nodiscard]] std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              std::type_identity_t<std::unique_ptr<Partitioner<Real>>> partitioner,
              Algorithm<Real> algorithm = default_algorithm<Real>());

} // namespace dsc
