// SPDX-License-Identifier: MIT
#include "scenes/run/strategy.h"

#include "dsc/base/error.h"
#include "dsc/parallel/copied/copy_executor.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/parallel/partition/blocks.h"
#include "dsc/parallel/partition/cells.h"
#include "dsc/parallel/partition/slabs.h"

#include <type_traits>

namespace dsc::scenes {

namespace {

// A partitioner's options, with the number of submeshes that is asked for or its own.
template <class PartitionOptions>
PartitionOptions with_submeshes(PartitionOptions options, const Submeshing& submeshing) {
    if (submeshing.submeshes > 0) {
        options.submeshes = submeshing.submeshes;
    }
    return options;
}

template <class Real>
std::unique_ptr<Executor<Real>> in_place(Complex<Real>& complex, const Options<Real>& options,
                                         const Submeshing& submeshing,
                                         std::unique_ptr<Partitioner<Real>> partitioner) {
    SubmeshOptions choices;
    choices.threads = submeshing.threads;
    choices.assignment = submeshing.assignment;
    choices.profile = submeshing.profile;
    if (submeshing.always_all_threads) {
        choices.vertices_per_thread = 1;
    }
    return std::make_unique<SubmeshExecutor<Real>>(complex, options, default_algorithm<Real>(),
                                                   std::move(partitioner), choices);
}

template <class Real, Slabbing slabbing>
std::unique_ptr<Executor<Real>> slabs(Complex<Real>& complex, const Options<Real>& options,
                                      const Submeshing& submeshing) {
    SlabOptions slabs = with_submeshes(SlabOptions{}, submeshing);
    slabs.slabbing = slabbing;
    slabs.degrees = submeshing.degrees;
    slabs.follow_shape = submeshing.follow_shape;
    return in_place<Real>(complex, options, submeshing,
                          std::make_unique<SlabPartitioner<Real>>(slabs));
}

template <class Real>
std::unique_ptr<Executor<Real>> blocks(Complex<Real>& complex, const Options<Real>& options,
                                       const Submeshing& submeshing) {
    return in_place<Real>(
        complex, options, submeshing,
        std::make_unique<BlockPartitioner<Real>>(with_submeshes(BlockOptions{}, submeshing)));
}

template <class Real>
std::unique_ptr<Executor<Real>> cells(Complex<Real>& complex, const Options<Real>& options,
                                      const Submeshing& submeshing) {
    return in_place<Real>(
        complex, options, submeshing,
        std::make_unique<CellPartitioner<Real>>(with_submeshes(CellOptions{}, submeshing)));
}

template <class Real>
std::unique_ptr<Executor<Real>> copies(Complex<Real>& complex, const Options<Real>& options,
                                       const Submeshing& submeshing) {
    CopyOptions copies = with_submeshes(CopyOptions{}, submeshing);
    copies.threads = submeshing.threads;
    return std::make_unique<CopyExecutor<Real>>(complex, options, default_algorithm<Real>(),
                                                copies);
}

} // namespace

const std::vector<StrategyEntry>& strategies() {
    static const std::vector<StrategyEntry> all{
        {Strategy::sequential, "sequential", "the whole mesh at once", 1, nullptr, nullptr},
        {Strategy::fixed, "fixed", "slabs of equal width [thesis 6.3]", SlabOptions{}.submeshes,
         slabs<double, Slabbing::fixed>, slabs<float, Slabbing::fixed>},
        {Strategy::counting, "counting", "slabs of equal numbers of triangles [thesis 6.3]",
         SlabOptions{}.submeshes, slabs<double, Slabbing::counting>,
         slabs<float, Slabbing::counting>},
        {Strategy::active, "active", "slabs of equal work", SlabOptions{}.submeshes,
         slabs<double, Slabbing::active>, slabs<float, Slabbing::active>},
        {Strategy::blocks, "blocks", "cut in two directions, three colours [thesis 6]",
         BlockOptions{}.submeshes, blocks<double>, blocks<float>},
        {Strategy::cells, "cells", "submeshes that follow the interface", CellOptions{}.submeshes,
         cells<double>, cells<float>},
        {Strategy::copy, "copy", "submeshes created and merged [thesis, algorithms 6.1 and 6.2]",
         CopyOptions{}.submeshes, copies<double>, copies<float>},
        {Strategy::reference, "reference", "the literal sequential method of the thesis", 1,
         nullptr, nullptr},
    };
    return all;
}

const StrategyEntry& entry_of(Strategy strategy) {
    return strategies().at(static_cast<std::size_t>(strategy));
}

const std::vector<Strategy>& all_strategies() {
    static const std::vector<Strategy> all = [] {
        std::vector<Strategy> values;
        for (const StrategyEntry& entry : strategies()) {
            values.push_back(entry.strategy);
        }
        return values;
    }();
    return all;
}

std::string to_string(Strategy strategy) { return entry_of(strategy).name; }

namespace {

template <class Keep>
std::string names_where(Keep keep) {
    std::string names;
    for (const StrategyEntry& entry : strategies()) {
        if (keep(entry.strategy)) {
            names += (names.empty() ? "" : ", ") + entry.name;
        }
    }
    return names;
}

} // namespace

Strategy parse_strategy(const std::string& name) {
    for (const StrategyEntry& entry : strategies()) {
        if (entry.name == name) {
            return entry.strategy;
        }
    }
    throw InputError("unknown strategy", "--strategy", "'" + name + "'",
                     names_where([](Strategy) { return true; }));
}

bool is_parallel(Strategy strategy) { return entry_of(strategy).in_double != nullptr; }

std::string parallel_strategies() { return names_where(is_parallel); }

std::uint32_t submeshes_of(Strategy strategy, const Submeshing& submeshing) {
    return is_parallel(strategy) && submeshing.submeshes > 0 ? submeshing.submeshes
                                                             : entry_of(strategy).submeshes;
}

template <class Real>
std::unique_ptr<Executor<Real>> make_executor(Complex<Real>& complex, const Options<Real>& options,
                                              Strategy strategy, const Submeshing& submeshing) {
    const StrategyEntry& entry = entry_of(strategy);
    MakeExecutor<Real> make = nullptr;
    if constexpr (std::is_same_v<Real, double>) {
        make = entry.in_double;
    } else {
        make = entry.in_float;
    }
    return make != nullptr ? make(complex, options, submeshing) : nullptr;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::unique_ptr<Executor<Real>> make_executor(Complex<Real>&, const Options<Real>&,   \
                                                           Strategy, const Submeshing&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
