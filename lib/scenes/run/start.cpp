// SPDX-License-Identifier: MIT
#include "scenes/run/start.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/circulate.h"
#include "dsc/complex/ranges.h"
#include "dsc/parallel/executors.h"
#include "topology/stage.h"

namespace dsc::scenes {

namespace {

// Locks the interface vertices on the domain boundary.
template <class Real>
void clamp_ends(Complex<Real>& complex) {
    for (const Vertex v : vertices(complex)) {
        bool is_on_boundary = false;
        bool is_end = false;
        for_each_corner(complex, v, [&](Corner c) {
            const Corner across = complex.twin(prev(c));
            is_on_boundary = is_on_boundary || is_border(across);
            is_end =
                is_end || (!is_border(across) && complex.phase_at(across) != complex.phase_at(c));
        });
        if (is_on_boundary && is_end) {
            complex.set_locked(v, true);
        }
    }
}

SizeOptions<double> sizes_of(const Setup& setup, const Parameters& parameters) {
    if (parameters.grade == 0) {
        return {}; // uniform edge lengths
    }
    SizeOptions<double> sizes = setup.sizes;
    sizes.growth = parameters.grade;
    return sizes;
}

} // namespace

template <class Real>
Complex<Real> first_complex(const Setup& setup, const Parameters& parameters, InputReport* report) {
    const double edges = (setup.domain.high - setup.domain.low).maxCoeff() / parameters.h;
    require(edges <= 1e5, "h", parameters.h, "at most 100000 edges along a side of the domain");
    InitialOptions options;
    options.edge_length = parameters.h;
    options.detail = parameters.detail;
    options.border_tolerance = parameters.border_tolerance;
    options.coverage = parameters.coverage;
    options.sizes = sizes_of(setup, parameters);
    if (setup.labels || !setup.curves.empty()) {
        const std::span<const dsc::Curve> curves(setup.curves);
        auto complex = setup.labels
                           ? initial_complex<Real>(setup.domain, *setup.labels, options, report)
                           : initial_complex<Real>(setup.domain, curves, options, report);
        if (setup.clamped) {
            clamp_ends(complex);
        }
        return complex;
    }
    std::vector<Shape> shapes;
    for (std::size_t i = 0; i < setup.outlines.size(); ++i) {
        shapes.push_back({setup.outlines[i], setup.phases.empty() ? Phase{1} : setup.phases[i]});
    }
    return setup.polygon ? initial_complex<Real>(*setup.polygon, shapes, options, report)
                         : initial_complex<Real>(setup.domain, shapes, options, report);
}

template <class Real>
Options<Real> scene_options(const Setup& setup, const Parameters& parameters) {
    Options<Real> options;
    options.edge_length = static_cast<Real>(parameters.h);
    choose_integrator(options, parameters.integrator);
    options.tolerance = parameters.tolerance;
    options.insertion = parameters.insertion;
    options.interface = parameters.interface;
    options.shuffle_seed = parameters.seed;
    options.sizes = sizes_in<Real>(sizes_of(setup, parameters));
    options.advected_phases = setup.advected;
    options.per_phase = setup.thresholds;
    if (setup.insertion) {
        options.insertion_function = *setup.insertion;
    }
    return options;
}

template <class Real>
TopologyOptions<Real> topology_options(const Parameters& parameters) {
    TopologyOptions<Real> options;
    options.rule = parameters.topology;
    options.contact = static_cast<Real>(parameters.contact);
    options.min_area = static_cast<Real>(parameters.min_area) * static_cast<Real>(parameters.h) *
                       static_cast<Real>(parameters.h);
    options.follows_seams = parameters.follows_seams;
    options.gives_back_area = parameters.gives_back;
    return options;
}

template <class Real>
std::unique_ptr<Simulation<Real>> make_simulation(Complex<Real>& complex,
                                                  const Options<Real>& options,
                                                  const TopologyOptions<Real>& topology,
                                                  Strategy strategy, const Submeshing& submeshing) {
    auto simulation = std::make_unique<Simulation<Real>>(
        complex, options, make_executor(complex, options, strategy, submeshing));
    if (topology.changes()) {
        simulation->add_stage(std::make_shared<TopologyStage<Real>>(topology));
    }
    return simulation;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template Complex<Real> first_complex(const Setup&, const Parameters&, InputReport*);           \
    template Options<Real> scene_options(const Setup&, const Parameters&);                         \
    template TopologyOptions<Real> topology_options(const Parameters&);                            \
    template std::unique_ptr<Simulation<Real>> make_simulation(                                    \
        Complex<Real>&, const Options<Real>&, const TopologyOptions<Real>&, Strategy,              \
        const Submeshing&);
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc::scenes
