// SPDX-License-Identifier: MIT
#include "dsc/parallel/parallel.h"

#include "dsc/algorithm/executor.h"
#include "dsc/algorithm/simulation.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/parallel/submesh_view.h"
#include "dsc/passes/algorithm.h"

#include <type_traits>

namespace dsc {

namespace {

template <class Real>
std::unique_ptr<Executor<Real>> cells(Complex<Real>& complex, const Options<Real>& options,
                                      const Parallel& parallel, Algorithm<Real> algorithm) {
    return make_executor<Real>(
        complex, options, parallel,
        std::make_unique<CellPartitioner<Real>>(CellOptions{.submeshes = submeshes_of(parallel)}),
        std::move(algorithm));
}

} // namespace

constinit const Division cells_division{"cells", "submeshes that follow the interface",
                                        CellOptions{}.submeshes, cells<double>, cells<float>};

std::uint32_t submeshes_of(const Parallel& parallel) {
    return parallel.submeshes > 0 ? parallel.submeshes : parallel.division->submeshes;
}

template <class Real>
std::unique_ptr<Executor<Real>> make_executor(Complex<Real>& complex, const Options<Real>& options,
                                              const Parallel& parallel, Algorithm<Real> algorithm) {
    complex.in_use.expect_free(); // before the new executor takes ids that another one counts
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
    complex.in_use.expect_free(); // before the new executor takes ids that another one counts
    return std::make_unique<SubmeshExecutor<Real>>(complex, options, std::move(algorithm),
                                                   std::move(partitioner), parallel);
}

template <class Real>
std::optional<SubmeshView> submeshes_in(const Executor<Real>& executor) {
    const auto* const in_place = dynamic_cast<const SubmeshExecutor<Real>*>(&executor);
    return in_place == nullptr ? std::nullopt : std::optional(in_place->view());
}

// A constructor of Simulation, defined here because the lower layers do not depend on threads.
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
