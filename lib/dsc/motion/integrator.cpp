// SPDX-License-Identifier: MIT
#include "dsc/motion/integrator.h"

namespace dsc {

template <class Real>
void integrate(Integrator integrator, const Velocity<Real>& velocity,
               std::span<const Point<Real>> positions, Real time, Real dt,
               std::span<Point<Real>> targets, IntegratorScratch<Real>& scratch) {
    const std::size_t n = positions.size();
    const auto& first = scratch.first;
    const auto stage_at = [&](const std::vector<Point<Real>>& slope, Real step) {
        scratch.stage.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            scratch.stage[i] = positions[i] + step * slope[i];
        }
    };
    const auto evaluate = [&](Real at) {
        scratch.slope.resize(n);
        velocity(scratch.stage, at, scratch.slope);
    };
    const Real half = Real(0.5) * dt;
    switch (integrator) {
    case Integrator::euler:
        for (std::size_t i = 0; i < n; ++i) {
            targets[i] = positions[i] + dt * first[i];
        }
        break;
    case Integrator::midpoint:
        stage_at(first, half);
        evaluate(time + half);
        for (std::size_t i = 0; i < n; ++i) {
            targets[i] = positions[i] + dt * scratch.slope[i];
        }
        break;
    case Integrator::rk4: {
        scratch.sum.assign(first.begin(), first.end());
        stage_at(first, half);
        evaluate(time + half);
        for (std::size_t i = 0; i < n; ++i) {
            scratch.sum[i] += Real(2) * scratch.slope[i];
        }
        stage_at(scratch.slope, half);
        evaluate(time + half);
        for (std::size_t i = 0; i < n; ++i) {
            scratch.sum[i] += Real(2) * scratch.slope[i];
        }
        stage_at(scratch.slope, dt);
        evaluate(time + dt);
        const Real sixth = dt / Real(6);
        for (std::size_t i = 0; i < n; ++i) {
            targets[i] = positions[i] + sixth * (scratch.sum[i] + scratch.slope[i]);
        }
        break;
    }
    }
}

template void integrate(Integrator, const Velocity<double>&, std::span<const Point<double>>, double,
                        double, std::span<Point<double>>, IntegratorScratch<double>&);
template void integrate(Integrator, const Velocity<float>&, std::span<const Point<float>>, float,
                        float, std::span<Point<float>>, IntegratorScratch<float>&);

} // namespace dsc
