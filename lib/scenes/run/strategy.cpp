// SPDX-License-Identifier: MIT
#include "scenes/run/strategy.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/error.h"
#include "dsc/parallel/executors.h"
#include "dsc/passes/algorithm.h"
#include "scenes/file/excerpt.h"
#include "thesis/divisions.h"

#include <algorithm>
#include <utility>

namespace dsc::scenes {

namespace {

// `sequential`, the divisions of the thesis and of the library, and `reference`.
std::vector<StrategyEntry> make_strategies() {
    std::vector<StrategyEntry> all{
        {Strategy::sequential, "sequential", "the whole mesh at once", 1, nullptr}};
    for (const Division* division : all_divisions) {
        all.push_back({static_cast<Strategy>(all.size()), std::string(division->name),
                       std::string(division->description), division->submeshes, division});
    }
    all.push_back({Strategy::reference, "reference", "the literal sequential method of the thesis",
                   1, nullptr});
    return all;
}

const StrategyEntry& entry_of(Strategy strategy) {
    return strategies().at(static_cast<std::size_t>(strategy));
}

} // namespace

const std::vector<StrategyEntry>& strategies() {
    static const std::vector<StrategyEntry> all = make_strategies();
    return all;
}

std::string to_string(Strategy strategy) { return entry_of(strategy).name; }

Strategy parse_strategy(const std::string& name) {
    const auto found = std::ranges::find(strategies(), name, &StrategyEntry::name);
    if (found != strategies().end()) {
        return found->strategy;
    }
    throw InputError({.what = "unknown strategy",
                      .where = "--strategy",
                      .value = "'" + name + "'",
                      .allowed = name_list(strategies(), &StrategyEntry::name)});
}

bool is_parallel(Strategy strategy) { return entry_of(strategy).division != nullptr; }

std::vector<Strategy> parallel_strategies() {
    std::vector<Strategy> parallel;
    for (const StrategyEntry& entry : strategies()) {
        if (entry.division != nullptr) {
            parallel.push_back(entry.strategy);
        }
    }
    return parallel;
}

std::uint32_t submeshes_of(Strategy strategy, const Submeshing& submeshing) {
    return is_parallel(strategy) && submeshing.submeshes > 0 ? submeshing.submeshes
                                                             : entry_of(strategy).submeshes;
}

template <class Real>
std::unique_ptr<Executor<Real>> make_executor(Complex<Real>& complex, const Options<Real>& options,
                                              Strategy strategy, const Submeshing& submeshing,
                                              const Algorithm<Real>* algorithm) {
    const Division* division = entry_of(strategy).division;
    if (division == nullptr) {
        if (algorithm == nullptr || strategy == Strategy::reference) {
            return nullptr;
        }
        return std::make_unique<Executor<Real>>(complex, options, *algorithm);
    }
    const Parallel parallel{.threads = submeshing.threads,
                            .division = division,
                            .submeshes = submeshing.submeshes,
                            .always_all_threads = submeshing.always_all_threads,
                            .profile = submeshing.profile};
    const auto passes = algorithm != nullptr ? *algorithm : default_algorithm<Real>();
    return dsc::make_executor(complex, options, parallel, passes);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::unique_ptr<Executor<Real>> make_executor(Complex<Real>&, const Options<Real>&,   \
                                                           Strategy, const Submeshing&,            \
                                                           const Algorithm<Real>*);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
