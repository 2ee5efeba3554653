// SPDX-License-Identifier: MIT
// The strategies by their names on the command line, and the executors behind them.
#pragma once

#include "dsc/algorithm/executor.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/parallel.h"
#include "dsc/passes/algorithm.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dsc::scenes {

/// How the passes are run; `reference` is the literal sequential method of the thesis.
enum class Strategy : std::uint8_t {
    sequential,
    fixed,
    counting,
    active,
    blocks,
    cells,
    copy,
    reference,
};

/// The options of the parallel strategies, as in `Parallel`; the strategy determines the division.
struct Submeshing {
    std::uint32_t threads = 1;
    std::uint32_t submeshes = 0;     ///< 0: the strategy's own choice
    bool always_all_threads = false; ///< even if fewer would be faster
    bool profile = false;            ///< measure times: see `SubmeshView`
};

/// The properties of a strategy.
struct StrategyEntry {
    Strategy strategy;
    std::string name;
    std::string description;
    std::uint32_t submeshes;  ///< default number; 0: chosen during the run
    const Division* division; ///< null unless it is parallel
};

/// One entry for each strategy, in their order.
[[nodiscard]] const std::vector<StrategyEntry>& strategies();

[[nodiscard]] std::string to_string(Strategy strategy);
/// Throws InputError, which lists all strategies.
[[nodiscard]] Strategy parse_strategy(const std::string& name);
/// Whether the strategy is neither `sequential` nor `reference`.
[[nodiscard]] bool is_parallel(Strategy strategy);
/// The strategies with `is_parallel`.
[[nodiscard]] std::vector<Strategy> parallel_strategies();

/// The number of submeshes: the given one, or the strategy's default; 0: chosen during the run.
[[nodiscard]] std::uint32_t submeshes_of(Strategy strategy, const Submeshing& submeshing);

/// The executor of an algorithm; null for `reference`, and for `sequential` with the default
/// algorithm. Throws InputError if the strategy does not support the options.
template <class Real>
std::unique_ptr<Executor<Real>> make_executor(Complex<Real>& complex, const Options<Real>& options,
                                              Strategy strategy, const Submeshing& submeshing,
                                              const Algorithm<Real>* algorithm = nullptr);

} // namespace dsc::scenes
