// SPDX-License-Identifier: MIT
// The integrators have their orders, for velocities that depend on position and on time.
#include "dsc/motion/integrator.h"

#include "support/pointwise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dsc::integrator_test {
namespace {

// A rotation about the origin with changing speed: by the angle sin(t) from time 0 to t.
const Velocity<double> changing_turn = test::pointwise([](const Point<double>& p, double time) {
    return Point<double>(std::cos(time) * Point<double>(-p.y(), p.x()));
});

template <class Real>
std::vector<Point<Real>> one_step(Integrator integrator, const Velocity<Real>& velocity,
                                  const std::vector<Point<Real>>& positions, Real time, Real dt) {
    IntegratorScratch<Real> scratch;
    scratch.first.resize(positions.size());
    velocity(positions, time, scratch.first);
    std::vector<Point<Real>> targets(positions.size());
    integrate<Real>(integrator, velocity, positions, time, dt, targets, scratch);
    return targets;
}

double error_after(Integrator integrator, int steps) {
    constexpr double duration = 2;
    std::vector<Point<double>> at{{1, 0}, {0, 0.5}, {-0.3, 0.2}};
    const auto first = at;
    const double dt = duration / steps;
    for (int i = 0; i < steps; ++i) {
        at = one_step<double>(integrator, changing_turn, at, i * dt, dt);
    }
    const double angle = std::sin(duration);
    double worst = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const Point<double> exact(std::cos(angle) * first[i].x() - std::sin(angle) * first[i].y(),
                                  std::sin(angle) * first[i].x() + std::cos(angle) * first[i].y());
        worst = std::max(worst, (at[i] - exact).norm());
    }
    return worst;
}

struct Order {
    Integrator integrator;
    double order;
    double largest_error; ///< after 160 steps
};

class Orders : public testing::TestWithParam<Order> {};

TEST_P(Orders, HalvingTheStepGainsTheOrder) {
    const auto [integrator, order, largest_error] = GetParam();
    for (const int steps : {40, 80}) {
        const double measured =
            std::log2(error_after(integrator, steps) / error_after(integrator, 2 * steps));
        EXPECT_NEAR(measured, order, 0.15) << steps << " steps";
    }
    EXPECT_LT(error_after(integrator, 160), largest_error);
}

INSTANTIATE_TEST_SUITE_P(Integrator, Orders,
                         testing::Values(Order{Integrator::euler, 1, 2e-2},
                                         Order{Integrator::midpoint, 2, 1e-4},
                                         Order{Integrator::rk4, 4, 1e-8}),
                         [](const auto& one) {
                             return std::string(to_string(one.param.integrator));
                         });

} // namespace
} // namespace dsc::integrator_test
