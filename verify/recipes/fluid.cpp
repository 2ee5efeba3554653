// SPDX-License-Identifier: MIT
// A fluid of one's own: a drop falls into a pool, which takes it.
#include <fluid/fluid.h>
#include <topology/topology.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

// The surface of the pool, and a drop above it: two curves of the interface.
static std::vector<dsc::Curve> pool_and_drop() {
    std::vector<dsc::Point<double>> circle;
    for (int i = 0; i <= 24; ++i) { // the last point closes it
        const double angle = 2 * std::numbers::pi * (i % 24) / 24;
        circle.emplace_back(0.5 + 0.15 * std::cos(angle), 0.72 + 0.15 * std::sin(angle));
    }
    return {{.points = {{0, 0.5}, {1, 0.5}}, .left = 0, .right = 1},
            {.points = circle, .left = 1, .right = 0}};
}

// Oil (phase 1) in air (phase 0), both heavier and thicker than real ones.
static dsc::FluidOptions oil_in_air() {
    dsc::FluidOptions fluids;
    fluids.phases = {{.phase = 0, .density = 10, .viscosity = 0.1},
                     {.phase = 1, .density = 1000, .viscosity = 5}};
    fluids.tensions = {{.one = 0, .other = 1, .tension = 20}};
    fluids.gravity = {0, -1};
    fluids.walls = {dsc::Wall::slip, dsc::Wall::slip, dsc::Wall::slip, dsc::Wall::slip};
    return fluids;
}

// The velocity at the vertices, for ParaView.
static dsc::VtuArray velocities(const dsc::FluidField& field) {
    std::vector<double> numbers;
    for (std::uint32_t v = 0; v < field.mesh.vertex_bound; ++v) {
        numbers.push_back(field.velocity[v].x());
        numbers.push_back(field.velocity[v].y());
    }
    return {"velocity", dsc::SimplexKind::vertex, 2, numbers};
}

// Runs until `end`, with a row of the series for each step and a frame every tenth.
static int fall(double end, const std::string& folder, std::ostream& series) {
    dsc::Options<double> options;
    options.edge_length = 0.04;
    options.sizes = {.growth = 1.3, .longest = 0.1}; // coarser away from the interface
    const std::vector<dsc::Curve> curves = pool_and_drop();
    auto complex = dsc::initial_complex<double>(
        {{0, 0}, {1, 1.2}}, curves, {.edge_length = options.edge_length, .sizes = options.sizes});
    dsc::Simulation<double> simulation(complex, options);
    const auto topology = std::make_shared<dsc::TopologyStage<double>>(
        dsc::TopologyOptions<double>{.rule = dsc::Topology::change, .gives_back_area = true});
    simulation.add_stage(topology); // without it, a film of air would stay for ever

    dsc::Fluid fluid(complex, oil_in_air());
    series << "time,energy,speed\n";
    int merged = 0;
    for (int step = 1; fluid.time() < end - 1e-9; ++step) {
        const dsc::FluidStep report = fluid.step(simulation, 0.01);
        if (report.moved.gave_up != dsc::GiveUp::none) {
            throw std::runtime_error("a step was too long");
        }
        for (const dsc::Event& event : topology->take_events()) {
            merged += event.kind == dsc::EventKind::merge ? 1 : 0;
        }
        series << fluid.time() << ',' << dsc::energy(fluid.field(), fluid.options()).sum() << ','
               << dsc::largest_speed(fluid.field(), fluid.options()) << '\n';
        if (step % 10 == 0) {
            const std::vector<dsc::VtuArray> arrays{velocities(fluid.field())};
            dsc::write_vtu(complex, folder + "/fall_" + std::to_string(step) + ".vtu", arrays);
        }
    }
    return merged;
}

TEST(Recipe, AFluidIsASimulationWithAFlow) {
    const auto folder = std::filesystem::temp_directory_path() / "dsc_recipe_fluid";
    std::filesystem::create_directories(folder);
    std::ostringstream series;
    EXPECT_EQ(fall(0.55, folder.string(), series), 1) << "the drop has become part of the pool";
    EXPECT_TRUE(std::filesystem::exists(folder / "fall_50.vtu"));
    EXPECT_NE(series.str().find("\n0.55,"), std::string::npos);
    std::filesystem::remove_all(folder);
}
