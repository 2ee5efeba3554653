// SPDX-License-Identifier: MIT
// Curvature flow by implicit steps: circles, constant areas, and interfaces that stay.
#include "support/simulation_testing.h"

#include "geometric_flows/curvature_flow.h"
#include "topology/stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::curvature_flow_test {
namespace {

using std::numbers::pi;
using test::disc_complex;
using test::expect_sound;
using test::options_for;

// --- circles: r^2 = r0^2 - 2 t times the multiplier ---------------------------------------------

// The relative error of the radius (from the area) at the time when the area should be half of the
// first; the fastest vertex moves by `step` edge lengths in a step.
double error_of_circle(double h, double step, const CurvatureFlowOptions& flow, double factor) {
    constexpr double radius = 0.3;
    auto complex = disc_complex<double>(h, {0.5, 0.5}, radius);
    const auto options = options_for<double>(h);
    Simulation<double> simulation(complex, options);
    const double last = radius / std::sqrt(2.0);
    const double duration = radius * radius / 4 / factor;
    const int steps = static_cast<int>(std::ceil(duration * factor / (step * h * last)));
    const InterfaceMotion<double> motion = curvature_flow<double>(flow);
    for (int k = 0; k < steps; ++k) {
        EXPECT_EQ(simulation.step(motion, 0, duration / steps).unreached, 0U);
    }
    expect_sound(complex, simulation);
    return std::sqrt(phase_area(complex, 1) / pi) / last - 1;
}

TEST(CurvatureFlow, IsStableForLongSteps) {
    EXPECT_LT(std::abs(error_of_circle(0.015, 2, {}, 1)), 1e-2);
}

TEST(CurvatureFlow, TakesTheMultipliersOfThePair) {
    const double plain = error_of_circle(0.03, 0.25, {}, 1);
    EXPECT_NEAR(error_of_circle(0.03, 0.25, {.tension = 2, .mobility = 3}, 6), plain, 1e-9);
    const CurvatureFlowOptions own{
        .tension = 9,
        .mobility = 9,
        .pairs = {{.one = 2, .other = 1, .tension = 7},
                  {.one = 1, .other = 0, .tension = 4, .mobility = 0.5}}};
    EXPECT_NEAR(error_of_circle(0.03, 0.25, own, 2), plain, 1e-9);
}

// The small disc vanishes within a step or at its end; in some runs edges of nearly zero length
// remain for the next step.
TEST(CurvatureFlow, APieceThatVanishesHoldsNoOtherOne) {
    constexpr double h = 0.04;
    for (const double radius : {0.09, 0.095, 0.1, 0.105}) {
        for (const double dt : {2.5e-4, 5e-4, 1e-3}) {
            SCOPED_TRACE(std::to_string(radius) + ", " + std::to_string(dt));
            const std::vector<Shape> shapes{{test::circle_points({0.7, 0.7}, 0.15, 60), 2},
                                            {test::circle_points({0.3, 0.3}, radius, 60), 1}};
            auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
            Simulation<double> simulation(complex, options_for<double>(h));
            simulation.add_stage(std::make_shared<TopologyStage<double>>(
                TopologyOptions<double>{.rule = Topology::change}));
            const auto motion = curvature_flow<double>();
            for (double time = 0; time < 0.0075; time += dt) {
                EXPECT_EQ(simulation.step(motion, 0, dt).held, 0U);
                const double exact = std::sqrt(0.15 * 0.15 - 2 * (time + dt));
                EXPECT_NEAR(std::sqrt(phase_area(complex, 2) / pi) / exact, 1, 0.01);
            }
            EXPECT_EQ(phase_area(complex, 1), 0);
            expect_sound(complex, simulation);
        }
    }
}

// --- areas that are kept ------------------------------------------------------------------------

// An ellipse becomes the circle of equal area.
TEST(CurvatureFlow, KeepsTheAreaOfAPhaseToRounding) {
    constexpr double h = 0.02;
    std::vector<Point<double>> ellipse = test::circle_points({0, 0}, 1, 90);
    for (auto& p : ellipse) {
        p = Point<double>(0.5 + 0.3 * p.x(), 0.5 + 0.15 * p.y());
    }
    const std::vector<Shape> shapes{{ellipse, 1}};
    auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
    const auto options = options_for<double>(h);
    Simulation<double> simulation(complex, options);
    const double area = phase_area(complex, 1);
    const auto motion = curvature_flow<double>({.kept_areas = {{1, area}}});
    for (int step = 0; step < 300; ++step) {
        EXPECT_EQ(simulation.step(motion, 0, 0.25 * h * 0.1).unreached, 0U);
        ASSERT_NEAR(phase_area(complex, 1) / area, 1, 1e-12);
    }
    expect_sound(complex, simulation);
    const double radius = std::sqrt(area / pi);
    for (const std::uint32_t v : simulation.interface()) {
        const double from = (complex.position(Vertex{v}) - Point<double>(0.5, 0.5)).norm();
        EXPECT_NEAR(from / radius, 1, 0.01);
    }
}

// --- what stays ----------------------------------------------------------------------------------

TEST(CurvatureFlow, LockedVerticesStay) {
    auto complex = disc_complex<double>(0.03);
    const auto options = options_for<double>(0.03);
    Simulation<double> simulation(complex, options);
    const Vertex locked{simulation.interface()[5]};
    complex.set_locked(locked, true);
    const Point<double> before = complex.position(locked);
    const double area = phase_area(complex, 1);
    for (int step = 0; step < 10; ++step) {
        EXPECT_EQ(simulation.step(curvature_flow<double>(), 0, 0.001).unreached, 0U);
    }
    EXPECT_EQ(complex.position(locked), before);
    EXPECT_LT(phase_area(complex, 1), area - 0.05);
    expect_sound(complex, simulation);
}

} // namespace
} // namespace dsc::curvature_flow_test
