// SPDX-License-Identifier: MIT
#include "dsc/parallel/parallel.h"

#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/parallel/partition/partition.h"

#include <array>
#include <type_traits>
#include <utility>

namespace dsc {

namespace {

// A partitioner's options, with the number of submeshes asked for or its default.
template <class PartitionOptions>
PartitionOptions with_submeshes(PartitionOptions options, const Parallel& parallel) {
    if (parallel.submeshes > 0) {
        options.submeshes = parallel.submeshes;
    }
    return options;
}

template <class Real, Slabbing slabbing>
std::unique_ptr<Executor<Real>> slabs(Complex<Real>& complex, const Options<Real>& options,
                                      const Parallel& parallel, Algorithm<Real> algorithm) {
    SlabOptions slabs = with_submeshes(SlabOptions{}, parallel);
    slabs.slabbing = slabbing;
    slabs.degrees = parallel.degrees;
    slabs.follow_shape = parallel.follow_shape;
    return make_executor<Real>(complex, options, parallel,
                               std::make_unique<SlabPartitioner<Real>>(slabs),
                               std::move(algorithm));
}

template <class Real>
std::unique_ptr<Executor<Real>> blocks(Complex<Real>& complex, const Options<Real>& options,
                                       const Parallel& parallel, Algorithm<Real> algorithm) {
    return make_executor<Real>(
        complex, options, parallel,
        std::make_unique<BlockPartitioner<Real>>(with_submeshes(BlockOptions{}, parallel)),
        std::move(algorithm));
}

template <class Real>
std::unique_ptr<Executor<Real>> cells(Complex<Real>& complex, const Options<Real>& options,
                                      const Parallel& parallel, Algorithm<Real> algorithm) {
    return make_executor<Real>(
        complex, options, parallel,
        std::make_unique<CellPartitioner<Real>>(with_submeshes(CellOptions{}, parallel)),
        std::move(algorithm));
}

} // namespace

constinit const DivisionEntry detail::fixed_division{
    "fixed", "slabs of equal width (thesis, section 6.3)", SlabOptions{}.submeshes,
    slabs<double, Slabbing::fixed>, slabs<float, Slabbing::fixed>};
constinit const DivisionEntry detail::counting_division{
    "counting", "slabs of equal numbers of triangles (thesis, section 6.3)",
    SlabOptions{}.submeshes, slabs<double, Slabbing::counting>, slabs<float, Slabbing::counting>};
constinit const DivisionEntry detail::active_division{
    "active", "slabs of equal work", SlabOptions{}.submeshes, slabs<double, Slabbing::active>,
    slabs<float, Slabbing::active>};
constinit const DivisionEntry detail::blocks_division{
    "blocks", "cut in two directions, three colours (thesis, section 6)", BlockOptions{}.submeshes,
    blocks<double>, blocks<float>};
constinit const DivisionEntry detail::cells_division{"cells", "submeshes that follow the interface",
                                                     CellOptions{}.submeshes, cells<double>,
                                                     cells<float>};

std::span<const Division> divisions() {
    static constexpr std::array all{Division::fixed, Division::counting, Division::active,
                                    Division::blocks, Division::cells};
    return all;
}

std::uint32_t submeshes_of(const Parallel& parallel) {
    return parallel.submeshes > 0 ? parallel.submeshes : parallel.division->submeshes;
}

template <class Real>
std::unique_ptr<Executor<Real>> make_executor(Complex<Real>& complex, const Options<Real>& options,
                                              const Parallel& parallel, Algorithm<Real> algorithm) {
    complex.in_use.expect_free(); // before an executor takes ids that the other one counts
    if constexpr (std::is_same_v<Real, double>) {
        return parallel.division->in_double(complex, options, parallel, std::move(algorithm));
    } else {
        return parallel.division->in_float(complex, options, parallel, std::move(algorithm));
    }
}

template <class Real>
std::unique_ptr<Executor<Real>>
make_executor(Complex<Real>& complex, const Options<Real>& options, const Parallel& parallel,
              std::type_identity_t<std::unique_ptr<Partitioner<Real>>> partitioner,
              Algorithm<Real> algorithm) {
    complex.in_use.expect_free(); // before an executor takes ids that the other one counts
    SubmeshOptions submeshes;
    submeshes.threads = parallel.threads;
    submeshes.assignment = parallel.assignment;
    submeshes.profile = parallel.profile;
    if (parallel.awake_us) {
        submeshes.awake = std::chrono::microseconds(*parallel.awake_us);
    }
    if (parallel.always_all_threads) {
        submeshes.vertices_per_thread = 1;
        submeshes.adapts_threads = false;
    }
    return std::make_unique<SubmeshExecutor<Real>>(complex, options, std::move(algorithm),
                                                   std::move(partitioner), submeshes);
}

template <class Real>
std::optional<SubmeshView> submeshes_in(const Executor<Real>& executor) {
    const auto* const in_place = dynamic_cast<const SubmeshExecutor<Real>*>(&executor);
    return in_place == nullptr ? std::nullopt : std::optional(in_place->view());
}

// Declared with the simulation, defined here: nothing in the lower layers knows of threads.
template <class Real>
Simulation<Real>::Simulation(Complex<Real>& complex, const Options<Real>& options,
                             const Parallel& parallel)
    : Simulation(complex, options, make_executor(complex, options, parallel)) {}

#define DSC_INSTANTIATE(Real)                                                                      \
    template std::unique_ptr<Executor<Real>> make_executor(Complex<Real>&, const Options<Real>&,   \
                                                           const Parallel&, Algorithm<Real>);      \
    template std::unique_ptr<Executor<Real>> make_executor(                                        \
        Complex<Real>&, const Options<Real>&, const Parallel&, std::unique_ptr<Partitioner<Real>>, \
        Algorithm<Real>);                                                                          \
    template std::optional<SubmeshView> submeshes_in(const Executor<Real>&);                       \
    template Simulation<Real>::Simulation(Complex<Real>&, const Options<Real>&, const Parallel&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
