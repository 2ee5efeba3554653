// SPDX-License-Identifier: MIT
#include "scenes/strategy.h"

#include "dsc/base/error.h"
#include "dsc/parallel/partition/blocks.h"
#include "dsc/parallel/partition/cells.h"
#include "dsc/parallel/copied/copy_executor.h"
#include "dsc/parallel/partition/slabs.h"
#include "dsc/parallel/in_place/submesh_executor.h"

namespace dsc::scenes {

namespace {

constexpr std::uint32_t default_slabs = 8;
constexpr std::uint32_t default_blocks = 16;

template <class Real>
std::unique_ptr<Partitioner<Real>> make_partitioner(Strategy strategy,
                                                    const Submeshing& submeshing) {
    const std::uint32_t submeshes = submeshes_of(strategy, submeshing);
    if (strategy == Strategy::cells) {
        CellOptions cells;
        cells.submeshes = submeshes;
        return std::make_unique<CellPartitioner<Real>>(cells);
    }
    if (strategy == Strategy::blocks) {
        BlockOptions blocks;
        blocks.submeshes = submeshes;
        return std::make_unique<BlockPartitioner<Real>>(blocks);
    }
    SlabOptions slabs;
    slabs.slabbing = strategy == Strategy::fixed      ? Slabbing::fixed
                     : strategy == Strategy::counting ? Slabbing::counting
                                                      : Slabbing::active;
    slabs.submeshes = submeshes;
    slabs.degrees = submeshing.degrees;
    slabs.follow_shape = submeshing.follow_shape;
    return std::make_unique<SlabPartitioner<Real>>(slabs);
}

} // namespace

std::string to_string(Strategy strategy) {
    switch (strategy) {
    case Strategy::sequential: return "sequential";
    case Strategy::fixed: return "fixed";
    case Strategy::counting: return "counting";
    case Strategy::active: return "active";
    case Strategy::blocks: return "blocks";
    case Strategy::cells: return "cells";
    case Strategy::copy: return "copy";
    case Strategy::reference: return "reference";
    }
    return "unknown";
}

Strategy parse_strategy(const std::string& name) {
    std::string names;
    for (const Strategy strategy : all_strategies) {
        if (to_string(strategy) == name) {
            return strategy;
        }
        names += (names.empty() ? "" : ", ") + to_string(strategy);
    }
    throw InputError("unknown strategy", "--strategy", "'" + name + "'", names);
}

bool is_parallel(Strategy strategy) {
    return strategy != Strategy::sequential && strategy != Strategy::reference;
}

std::string parallel_strategies() {
    std::string names;
    for (const Strategy strategy : all_strategies) {
        if (is_parallel(strategy)) {
            names += (names.empty() ? "" : ", ") + to_string(strategy);
        }
    }
    return names;
}

std::uint32_t submeshes_of(Strategy strategy, const Submeshing& submeshing) {
    if (!is_parallel(strategy)) {
        return 1;
    }
    if (submeshing.submeshes > 0 || strategy == Strategy::cells) {
        return submeshing.submeshes;
    }
    return strategy == Strategy::blocks ? default_blocks : default_slabs;
}

template <class Real>
std::unique_ptr<Executor<Real>> make_executor(Complex<Real>& complex, const Options<Real>& options,
                                              Strategy strategy, const Submeshing& submeshing) {
    if (!is_parallel(strategy)) {
        return nullptr;
    }
    if (strategy == Strategy::copy) {
        CopyOptions copies;
        copies.submeshes = submeshes_of(strategy, submeshing);
        copies.threads = submeshing.threads;
        return std::make_unique<CopyExecutor<Real>>(complex, options, default_algorithm<Real>(),
                                                    copies);
    }
    SubmeshOptions choices;
    choices.threads = submeshing.threads;
    choices.assignment = submeshing.assignment;
    choices.profile = submeshing.profile;
    if (submeshing.always_all_threads) {
        choices.vertices_per_thread = 1;
    }
    return std::make_unique<SubmeshExecutor<Real>>(complex, options, default_algorithm<Real>(),
                                                   make_partitioner<Real>(strategy, submeshing),
                                                   choices);
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::unique_ptr<Executor<Real>> make_executor(Complex<Real>&, const Options<Real>&,   \
                                                           Strategy, const Submeshing&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
