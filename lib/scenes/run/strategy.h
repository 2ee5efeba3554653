// SPDX-License-Identifier: MIT
// The strategies by the names that the command lines take, and the executors behind them.
#pragma once

#include "dsc/parallel/parallel.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
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

/// What the parallel strategies are asked for; the division follows from the strategy.
using Submeshing = Parallel;

/// All that there is to know of a strategy.
struct StrategyEntry {
    Strategy strategy;
    std::string name;
    std::string description;
    std::uint32_t submeshes;          ///< where no number is asked for; 0: chosen as it runs
    std::optional<Division> division; ///< of the parallel ones
};

/// One entry for each strategy, in their order.
[[nodiscard]] const std::vector<StrategyEntry>& strategies();
[[nodiscard]] const StrategyEntry& entry_of(Strategy strategy);

[[nodiscard]] const std::vector<Strategy>& all_strategies();
[[nodiscard]] std::string to_string(Strategy strategy);
/// Throws InputError, naming those that there are.
[[nodiscard]] Strategy parse_strategy(const std::string& name);
/// Not sequential, and not the reference.
[[nodiscard]] bool is_parallel(Strategy strategy);
/// "fixed, counting, ...": those of which is_parallel is true.
[[nodiscard]] std::string parallel_strategies();

/// The submeshes that this makes: the number asked for, or the strategy's own; 0: chosen as it
/// runs.
[[nodiscard]] std::uint32_t submeshes_of(Strategy strategy, const Submeshing& submeshing);

/// The executor; null for `sequential` and `reference`. Throws InputError where options make no
/// sense for this strategy.
template <class Real>
std::unique_ptr<Executor<Real>> make_executor(Complex<Real>& complex, const Options<Real>& options,
                                              Strategy strategy, const Submeshing& submeshing);

} // namespace dsc::scenes
