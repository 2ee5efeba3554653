// SPDX-License-Identifier: MIT
#include "dsc/parallel/parallel.h"

#include "dsc/parallel/copied/copy_executor.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/parallel/partition/blocks.h"
#include "dsc/parallel/partition/cells.h"
#include "dsc/parallel/partition/slabs.h"

namespace dsc {

namespace {

constexpr std::uint32_t default_slabs = 8;
constexpr std::uint32_t default_blocks = 16;

template <class Real>
std::unique_ptr<Partitioner<Real>> make_partitioner(const Parallel& parallel) {
    const std::uint32_t submeshes = submeshes_of(parallel);
    const auto slabs = [&](Slabbing slabbing) {
        SlabOptions options;
        options.slabbing = slabbing;
        options.submeshes = submeshes;
        options.degrees = parallel.degrees;
        options.follow_shape = parallel.follow_shape;
        return std::make_unique<SlabPartitioner<Real>>(options);
    };
    switch (parallel.division) {
    case Division::fixed: return slabs(Slabbing::fixed);
    case Division::counting: return slabs(Slabbing::counting);
    case Division::active: return slabs(Slabbing::active);
    case Division::blocks: {
        BlockOptions blocks;
        blocks.submeshes = submeshes;
        return std::make_unique<BlockPartitioner<Real>>(blocks);
    }
    case Division::cells:
    case Division::copy: break;
    }
    CellOptions cells;
    cells.submeshes = submeshes;
    return std::make_unique<CellPartitioner<Real>>(cells);
}

} // namespace

std::uint32_t submeshes_of(const Parallel& parallel) {
    if (parallel.submeshes > 0 || parallel.division == Division::cells) {
        return parallel.submeshes;
    }
    return parallel.division == Division::blocks ? default_blocks : default_slabs;
}

template <class Real>
std::unique_ptr<Executor<Real>> make_executor(Complex<Real>& complex, const Options<Real>& options,
                                              const Parallel& parallel, Algorithm<Real> algorithm) {
    if (parallel.division == Division::copy) {
        CopyOptions copies;
        copies.submeshes = submeshes_of(parallel);
        copies.threads = parallel.threads;
        return std::make_unique<CopyExecutor<Real>>(complex, options, std::move(algorithm), copies);
    }
    SubmeshOptions submeshes;
    submeshes.threads = parallel.threads;
    submeshes.profile = parallel.profile;
    if (parallel.always_all_threads) {
        submeshes.vertices_per_thread = 1;
    }
    return std::make_unique<SubmeshExecutor<Real>>(complex, options, std::move(algorithm),
                                                   make_partitioner<Real>(parallel), submeshes);
}

// Declared with the simulation, defined here: nothing below this room knows of threads.
template <class Real>
Simulation<Real>::Simulation(Complex<Real>& complex, const Options<Real>& options,
                             const Parallel& parallel)
    : Simulation(complex, options, make_executor(complex, options, parallel)) {}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::unique_ptr<Executor<Real>> make_executor(Complex<Real>&, const Options<Real>&,   \
                                                           const Parallel&, Algorithm<Real>);      \
    template Simulation<Real>::Simulation(Complex<Real>&, const Options<Real>&, const Parallel&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
