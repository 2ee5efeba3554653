// SPDX-License-Identifier: MIT
#include "thesis/algorithm/centred_difference.h"

#include "dsc/complex/circulate.h"
#include "dsc/geometry/points.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace dsc {

namespace {

constexpr const char* name_of_past = "thesis.past";

/// The attribute, which must exist: several threads may ask for it at once.
template <class Real>
VertexAttribute<Past<Real>>& known_past(Complex<Real>& complex) {
    return complex.attributes.template get<Vertex, Past<Real>>(name_of_past);
}

/// Whether a step is shorter than the fraction `longest_at_rest` of each edge at its vertex.
/// O(star).
template <class Real>
bool is_nearly_at_rest(const Complex<Real>& complex, Vertex v, const Point<Real>& way) {
    const Point<Real> here = complex.position(v);
    Real shortest = std::numeric_limits<Real>::infinity();
    for_each_corner(complex, v, [&](Corner c) {
        for (const Corner other : {next(c), prev(c)}) {
            const Point<Real> there = complex.position(Vertex{complex.vertex(other)});
            shortest = std::min(shortest, distance<Real>(here, there));
        }
    });
    return way.norm() < static_cast<Real>(longest_at_rest) * shortest;
}

template <class Real>
class CentredDifference final : public CustomIntegrator<Real> {
public:
    void begin(Complex<Real>& complex) const override { past_of(complex); }

    // The polynomial of second order through the last two positions, with the velocity here: for
    // equal steps the leapfrog x(t + dt) = x(t - dt) + 2 dt v(t).
    Real integrate(const IntegratorStep<Real>& step, const Velocity<Real>& velocity, Real time,
                   IntegratorScratch<Real>& scratch) const override {
        const auto& pasts = known_past(step.complex);
        const Real dt = step.dt;
        const auto serves = [&](std::size_t i) {
            const Vertex v{step.vertices[i]};
            const Past<Real>& past = pasts[v];
            return past.serves(dt) && (!past.is_crossed_by(scratch.first[i]) ||
                                       is_nearly_at_rest(step.complex, v, past.way));
        };
        bool all = true;
        for (std::size_t i = 0; i < step.vertices.size() && all; ++i) {
            all = serves(i);
        }
        if (!all) {
            dsc::integrate<Real>(Integrator::midpoint, velocity, step.positions, time, dt,
                                 step.targets, scratch);
        }
        for (std::size_t i = 0; i < step.vertices.size(); ++i) {
            if (serves(i)) {
                const Past<Real>& past = pasts[Vertex{step.vertices[i]}];
                const Real ratio = dt / past.dt;
                step.targets[i] = step.positions[i] + (1 + ratio) * dt * scratch.first[i] -
                                  ratio * ratio * past.way;
            }
        }
        return 0;
    }

    void accept(const IntegratorStep<Real>& step) const override {
        auto& pasts = known_past(step.complex);
        for (std::size_t i = 0; i < step.vertices.size(); ++i) {
            const Point<Real> way = step.targets[i] - step.positions[i];
            const bool is_known = step.held[i] == 0 && way.allFinite();
            Past<Real>& past = pasts[Vertex{step.vertices[i]}];
            const Real growth = past.serves(step.dt) ? past.growth_after(step.dt) : Real(1);
            past = is_known ? Past<Real>{way, step.dt, growth} : Past<Real>{};
        }
    }

    void forget(Complex<Real>& complex, std::span<const std::uint32_t> vertices) const override {
        auto& pasts = past_of(complex);
        for (const std::uint32_t v : vertices) {
            pasts[Vertex{v}] = {};
        }
    }
};

} // namespace

template <class Real>
VertexAttribute<Past<Real>>& past_of(Complex<Real>& complex) {
    if (complex.attributes.contains(name_of_past)) {
        return known_past(complex);
    }
    return complex.attributes.template add<Vertex>(
        name_of_past, Past<Real>{},
        [](const Past<Real>&, const Past<Real>&, double) { return Past<Real>{}; });
}

template <class Real>
std::shared_ptr<const CustomIntegrator<Real>> centred_difference() {
    static const auto one = std::make_shared<const CentredDifference<Real>>();
    return one;
}

#define DSC_INSTANTIATE(Real)                                                                      \
    template VertexAttribute<Past<Real>>& past_of(Complex<Real>&);                                 \
    template std::shared_ptr<const CustomIntegrator<Real>> centred_difference();
DSC_INSTANTIATE(double)
DSC_INSTANTIATE(float)
#undef DSC_INSTANTIATE

} // namespace dsc
