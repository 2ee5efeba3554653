// SPDX-License-Identifier: MIT
// Fluids whose forces are in balance stay at rest up to rounding, with exact pressures.
#include "fluid/scenes.h"

#include <gtest/gtest.h>

namespace dsc::rest_test {
namespace {

using fluid_scenes::Tank;

double jump(const Fluid& fluid) {
    return mean_pressure(fluid.field(), 1) - mean_pressure(fluid.field(), 0);
}

// The pressure jump of a regular polygon: tension / d, where d is the distance of its edges from
// the centre. Two edges at the angle a pull at their vertex with 2 sin(a / 2) times the tension;
// the pressure pushes with its jump times cos(a / 2) times an edge of length 2 d tan(a / 2).
double exact_jump(const Complex<double>& complex, double tension) {
    const VertexLoop outline = outlines(complex, 1).front();
    const Point<double> middle = (complex.position(outline[0]) + complex.position(outline[1])) / 2;
    return tension / (middle - Point<double>(0.5, 0.5)).norm();
}

TEST(FluidRest, ADropStaysAsItIs) {
    for (const double h : {0.08, 0.04}) {
        Tank tank = fluid_scenes::static_drop(h, 25);
        for (int step = 0; step < 5; ++step) {
            (void)tank.fluid.step(tank.simulation, 0.01);
        }
        EXPECT_LT(largest_speed(tank.fluid.field(), tank.fluid.options()), 1e-12)
            << "edge length " << h;
        EXPECT_NEAR(jump(tank.fluid) / exact_jump(tank.complex, 25), 1, 1e-12);
        EXPECT_NEAR(jump(tank.fluid), 100, 70 * h * h) << "a disc";
        EXPECT_NEAR(cubic_outline(tank.complex, 1).circularity(), 1, 20 * h * h * h * h);
    }
}

// A drop with unequal edges: groups of three are longer and shorter by turns.
Tank unequal_drop(double edge_length) {
    const int n = 6 * static_cast<int>(std::ceil(2 * std::numbers::pi * 0.25 / edge_length / 6));
    std::vector<Point<double>> outline;
    for (int i = 0; i < n; ++i) {
        const double angle =
            2 * std::numbers::pi * (i + 0.2 * std::sin(std::numbers::pi * i / 3)) / n;
        outline.emplace_back(0.5 + 0.25 * std::cos(angle), 0.5 + 0.25 * std::sin(angle));
    }
    Options<double> options;
    options.edge_length = 1.3 * edge_length; // none is cut
    FluidOptions fluids;
    fluids.phases = {{.phase = 0}, {.phase = 1}};
    fluids.tensions = {{.tension = 25}};
    return {{{0, 0}, {1, 1}}, {{outline, 1}}, options, fluids};
}

// A polygon of unequal edges is not in balance; its vertices slide until the edges are equal.
TEST(FluidRest, UnequalEdgesBecomeEqualAndTheDropComesToRest) {
    Tank tank = unequal_drop(0.06);
    (void)tank.fluid.step(tank.simulation, 0.01);
    const double first = largest_speed(tank.fluid.field(), tank.fluid.options());
    EXPECT_GT(first, 1e-4);
    for (int step = 0; step < 100; ++step) {
        (void)tank.fluid.step(tank.simulation, 0.01);
    }
    EXPECT_LT(largest_speed(tank.fluid.field(), tank.fluid.options()), 1e-3 * first);
    EXPECT_NEAR(jump(tank.fluid) / exact_jump(tank.complex, 25), 1, 1e-4);
    EXPECT_NEAR(cubic_outline(tank.complex, 1).circularity(), 1, 1e-4);
}

// Velocities in a void are not counted as flow.
TEST(FluidRest, AVoidHasNoSpeed) {
    Tank tank = fluid_scenes::static_drop(0.08, 25);
    FluidField field = tank.fluid.field();
    for (const SnapshotTriangle& t : field.mesh.triangles) {
        for (const std::uint32_t node : t.nodes) {
            field.velocity[node] = t.phase == 0 ? Point<double>(0, 3) : field.velocity[node];
        }
    }
    FluidOptions options = tank.fluid.options();
    EXPECT_EQ(largest_speed(field, options), 3);
    for (const SnapshotEdge& edge : field.mesh.interface) {
        field.velocity[edge.from] = field.velocity[edge.to] = {0, 0};
        field.velocity[edge.middle] = {2, 0};
    }
    options.phases[0].is_void = true;
    EXPECT_EQ(largest_speed(field, options), 2);
}

TEST(FluidRest, AHeavyFluidLiesBelowALightOne) {
    const std::vector<Curve> curves{{.points = {{0, 0.5}, {1, 0.5}}, .left = 1, .right = 0}};
    Complex<double> complex =
        initial_complex<double>({{0, 0}, {1, 1}}, curves, {.edge_length = 0.1});
    Simulation<double> simulation(complex, {.edge_length = 0.1});
    FluidOptions options;
    options.phases = {{.phase = 0, .density = 1000}, {.phase = 1, .density = 1}};
    options.tensions = {{.tension = 1}};
    options.gravity = {0, -10};
    options.walls.left = Wall::slip;
    Fluid fluid(complex, options);
    for (int step = 0; step < 3; ++step) {
        (void)fluid.step(simulation, 0.1);
    }
    EXPECT_LT(largest_speed(fluid.field(), fluid.options()), 1e-12);
    const auto pressure = [&](double y) {
        return pressure_at(fluid.field(), find_spot(fluid.field().mesh, {0.3, y}, 0));
    };
    EXPECT_NEAR(pressure(0.1) - pressure(0.4), 1000 * 10 * 0.3, 1e-8);
    EXPECT_NEAR(pressure(0.6) - pressure(0.9), 1 * 10 * 0.3, 1e-8);
    EXPECT_NEAR(pressure(0.5 - 1e-9) - pressure(0.5 + 1e-9), 0, 1e-4);
    // Each phase fills half of the domain.
    EXPECT_NEAR(mean_pressure(fluid.field(), 0) + mean_pressure(fluid.field(), 1), 0, 1e-8);
}

} // namespace
} // namespace dsc::rest_test
