// SPDX-License-Identifier: MIT
// A drop falls into a pool of the same phase and becomes part of it: a fluid beside the stage that
// changes the topology.
#include "fluid/scenes.h"

#include <topology/topology.h>

#include <gtest/gtest.h>

namespace dsc::falling_drop_test {
namespace {

TEST(FluidFallingDrop, ThePoolTakesItAndTheFlowGoesOn) {
    std::vector<Point<double>> drop = fluid_scenes::disc({0.5, 0.72}, 0.15, 0.04);
    drop.push_back(drop.front());
    const std::vector<Curve> curves{{.points = {{0, 0.5}, {1, 0.5}}, .left = 0, .right = 1},
                                    {.points = drop, .left = 1, .right = 0}};
    Options<double> options;
    options.edge_length = 0.04;
    options.sizes.growth = 1.3;
    options.sizes.longest = 0.1;
    Complex<double> complex = initial_complex<double>(
        {{0, 0}, {1, 1.2}}, curves, {.edge_length = 0.04, .sizes = options.sizes});
    Simulation<double> simulation(complex, options);
    const auto topology = std::make_shared<TopologyStage<double>>(
        TopologyOptions<double>{.rule = Topology::change, .gives_back_area = true});
    simulation.add_stage(topology);
    FluidOptions fluids;
    fluids.phases = {{.phase = 0, .density = 10, .viscosity = 0.1},
                     {.phase = 1, .density = 1000, .viscosity = 5}};
    fluids.tensions = {{.tension = 20}};
    fluids.gravity = {0, -1};
    fluids.walls = {Wall::slip, Wall::slip, Wall::slip, Wall::slip};
    Fluid fluid(complex, fluids);
    const double area = phase_area(complex, 1);
    double before = energy(fluid.field(), fluids).sum();
    int merged = 0;
    for (int step = 0; step < 60; ++step) {
        const FluidStep report = fluid.step(simulation, 0.01);
        EXPECT_EQ(report.moved.unreached, 0U);
        EXPECT_TRUE(validate(complex).ok());
        for (const Event& event : topology->take_events()) {
            merged += event.kind == EventKind::merge ? 1 : 0;
        }
        const double now = energy(fluid.field(), fluids).sum();
        EXPECT_LT(now, before * (1 + 1e-4)) << "at time " << fluid.time();
        before = now;
    }
    EXPECT_EQ(merged, 1);
    EXPECT_EQ(outlines(complex, 1).size(), 1U);
    EXPECT_NEAR(phase_area(complex, 1) / area, 1, 1e-12);
}

} // namespace
} // namespace dsc::falling_drop_test
