// SPDX-License-Identifier: MIT
// Flows that see the interface, in steps: growth along the normal, and one phase that moves.
#include "support/interface_view_testing.h"
#include "support/simulation_testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::interface_flow_test {
namespace {

using std::numbers::pi;
using test::coarse;
using test::disc_complex;
using test::expect_sound;
using test::options_for;

// --- the examples of the README -----------------------------------------------------------------

const InterfaceFlow<double> growth = vertex_flow<double>(
    [](const auto& view, std::size_t i, double) { return dsc::normal(view, i); });

const InterfaceFlow<double> only_phase_1 =
    vertex_flow<double>([](const auto& view, std::size_t i, double) {
        return dsc::borders_on(view, i, 1) ? Point<double>(1, 0) : Point<double>(0, 0);
    });

// --- convergence --------------------------------------------------------------------------------

// The error of the radius, by area, of a circle that grows from 0.2 to 0.3.
double error_of_growth(double h) {
    auto complex = disc_complex<double>(h, {0.5, 0.5}, 0.2);
    const auto options = options_for<double>(h);
    Simulation<double> simulation(complex, options);
    const int steps = static_cast<int>(std::ceil(0.1 / (0.4 * h)));
    for (int step = 0; step < steps; ++step) {
        EXPECT_EQ(simulation.step(growth, 0, 0.1 / steps).unreached, 0U);
    }
    expect_sound(complex, simulation);
    return std::abs(std::sqrt(phase_area(complex, 1) / pi) - 0.3);
}

TEST(InterfaceFlow, ACircleGrowsAlongItsNormalToSecondOrder) {
    const std::array<double, 3> errors{error_of_growth(0.04), error_of_growth(0.02),
                                       error_of_growth(0.01)};
    EXPECT_LT(errors[2], 2e-5);
    EXPECT_GT(std::log2(errors[0] / errors[2]) / 2, 1.8)
        << errors[0] << ", " << errors[1] << ", " << errors[2];
}

// --- who moves ----------------------------------------------------------------------------------

TEST(InterfaceFlow, OnePhaseMovesAndTheOtherStays) {
    const std::vector<Shape> shapes{{test::circle_points({0.3, 0.25}, 0.15, 24), 1},
                                    {test::circle_points({0.3, 0.75}, 0.15, 24), 2}};
    auto complex = initial_complex<double>({}, shapes, {.edge_length = coarse});
    const auto options = options_for<double>(coarse);
    Simulation<double> simulation(complex, options);
    const auto middle_of = [&](Phase phase) {
        Point<double> sum = Point<double>::Zero();
        for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
            if (complex.is_alive(Triangle{t}) && complex.phase(Triangle{t}) == phase) {
                const auto [a, b, c] = complex.vertices_of(Triangle{t});
                const Point<double> p = complex.position(a);
                const Point<double> u = complex.position(b) - p;
                const Point<double> w = complex.position(c) - p;
                sum += (u.x() * w.y() - u.y() * w.x()) / 2 * (p + (u + w) / 3);
            }
        }
        return Point<double>(sum / phase_area(complex, phase));
    };
    const double area = phase_area(complex, 1);
    for (int step = 0; step < 20; ++step) {
        EXPECT_EQ(simulation.step(only_phase_1, 0, 0.02).unreached, 0U);
    }
    expect_sound(complex, simulation);
    EXPECT_LT((middle_of(1) - Point<double>(0.7, 0.25)).norm(), 1e-12);
    EXPECT_LT((middle_of(2) - Point<double>(0.3, 0.75)).norm(), 1e-12);
    EXPECT_NEAR(phase_area(complex, 1), area, 1e-12);
}

TEST(InterfaceFlow, ReadsAttributesAndMovesWhatItWritesOnly) {
    auto complex = disc_complex<double>(coarse);
    auto& speeds = complex.attributes.add<Vertex>("speed", 0.0);
    const auto options = options_for<double>(coarse);
    Simulation<double> simulation(complex, options);
    const auto list = simulation.interface();
    speeds[Vertex{list[3]}] = 0.01;
    speeds[Vertex{list[4]}] = 0.02;
    const InterfaceFlow<double> flow = [](const auto& view, std::size_t begin, std::size_t end,
                                          double, auto velocities) {
        const auto& read = view.complex.attributes.template get<Vertex, double>("speed");
        for (std::size_t i = begin; i < end; ++i) {
            if (const double speed = read[view.vertices[i]]; speed != 0) {
                velocities[i] = Point<double>(speed, 0);
            }
        }
    };
    std::vector<Point<double>> before;
    for (const std::uint32_t v : list) {
        before.push_back(complex.position(Vertex{v}));
    }
    EXPECT_EQ(simulation.step(flow, 0, 1).unreached, 0U);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const double way = i == 3 ? 0.01 : (i == 4 ? 0.02 : 0.0);
        EXPECT_LT((complex.position(Vertex{list[i]}) - before[i] - Point<double>(way, 0)).norm(),
                  1e-15);
    }
}

} // namespace
} // namespace dsc::interface_flow_test
