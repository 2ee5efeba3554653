// SPDX-License-Identifier: MIT
// Options, domains and archives that a fluid refuses.
#include "fluid/scenes.h"

#include "support/refusal.h"
#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace dsc::fluid_options_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Valid options of two fluids, which each case changes.
void expect_refused(const std::string& words, const std::function<void(FluidOptions&)>& change) {
    const std::vector<Shape> shapes{{fluid_scenes::disc({0.5, 0.5}, 0.25, 0.2), 1}};
    const auto complex = initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = 0.2});
    FluidOptions options;
    options.phases = {{.phase = 0}, {.phase = 1}};
    options.tensions = {{.tension = 1}};
    change(options);
    const std::string sentence = test::refusal([&] { const Fluid fluid(complex, options); });
    EXPECT_NE(sentence.find(words), std::string::npos) << words << ": " << sentence;
}

TEST(FluidOptions, PropertiesAreFiniteAndOfOneSign) {
    for (const double bad : {-1.0, infinity, not_a_number}) {
        expect_refused("density of phase 1", [&](auto& o) { o.phases[1].density = bad; });
        expect_refused("viscosity of phase 1", [&](auto& o) { o.phases[1].viscosity = bad; });
        expect_refused("tension of phases 0 and 1", [&](auto& o) { o.tensions[0].tension = bad; });
    }
    for (const double bad : {0.0, 180.0, not_a_number}) {
        expect_refused("contact angle of phases 0 and 1",
                       [&](auto& o) { o.tensions[0].contact_angle = bad; });
    }
    expect_refused("viscosity of phase 1", [](auto& o) { o.phases[1].viscosity = 0; });
    expect_refused("gravity, y", [](auto& o) { o.gravity = {0, infinity}; });
    expect_refused("implicitness", [](auto& o) { o.implicitness = 0.4; });
    expect_refused("tolerance", [](auto& o) { o.tolerance = -1; });
    expect_refused("threads", [](auto& o) { o.threads = 0; });
    expect_refused("all phases are void, so there is nothing to solve for",
                   [](auto& o) { o.phases[0].is_void = o.phases[1].is_void = true; });
}

TEST(FluidOptions, SidesAreOnTheDomainAndHaveOneCondition) {
    const auto inwards = [](const Point<double>&, double) { return 1.0; };
    const auto still = [](const Point<double>&, double) { return Point<double>(0, 0); };
    expect_refused("side 'inlet'", [](auto& o) { o.sides = {{.name = "inlet"}}; });
    expect_refused("side 'left'", [](auto& o) { o.sides = {{.name = "left"}, {.name = "left"}}; });
    expect_refused("both a velocity and an inflow", [&](auto& o) {
        o.sides = {{.name = "left", .velocity = still, .inflow = inwards}};
    });
    expect_refused("slips or is open", [&](auto& o) {
        o.sides = {{.name = "left", .wall = Wall::open, .inflow = inwards}};
    });
    expect_refused("either sides or wall_at", [](auto& o) {
        o.sides = {{.name = "left"}};
        o.wall_at = [](const Point<double>&) { return Wall::slip; };
    });
    expect_refused("more flows into the domain than out of it",
                   [&](auto& o) { o.sides = {{.name = "left", .inflow = inwards}}; });
}

// An inlet that begins so near to a corner that its first point is left out of a coarse mesh.
TEST(FluidOptions, AnEndOfASideWithinAWallIsAVertex) {
    const Polygon domain({{0, 0}, {0.01, 0}, {0.5, 0}, {2, 0}, {2, 1}, {0, 1}});
    FluidOptions options;
    options.phases = {{.phase = 0}};
    const std::vector<std::string> names{"wall", "inlet", "wall", "outlet", "wall", "wall"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        options.domain_edges.push_back(
            {domain.outline[i], domain.outline[(i + 1) % names.size()], names[i]});
    }
    options.sides = {{.name = "inlet", .inflow = [](const auto&, double) { return 1.0; }},
                     {.name = "outlet", .wall = Wall::open}};
    for (const double h : {0.04, 0.1}) {
        const auto complex =
            initial_complex<double>(domain, std::vector<Shape>{}, {.edge_length = h});
        const std::string sentence = test::refusal([&] { const Fluid fluid(complex, options); });
        EXPECT_EQ(sentence.find("two sides meet where the mesh has no vertex") != sentence.npos,
                  h == 0.1)
            << sentence;
    }
}

TEST(FluidOptions, EachPhaseAndEachPairThatMeetsIsGivenOnce) {
    expect_refused("phase 1", [](auto& o) {
        o.phases.pop_back();
        o.tensions.clear();
    });
    expect_refused("given twice", [](auto& o) { o.phases.push_back({.phase = 1}); });
    expect_refused("has no tension", [](auto& o) { o.tensions.clear(); });
    expect_refused("given twice", [](auto& o) {
        o.tensions = {{.one = 0, .other = 1}, {.one = 1, .other = 0}};
    });
    expect_refused("names one phase twice", [](auto& o) { o.tensions = {{.one = 1, .other = 1}}; });
    expect_refused("phase 7", [](auto& o) { o.tensions = {{.one = 0, .other = 7}}; });
}

// n x n squares of side 1 without one; the upper right corner of the hole is moved to the right.
Complex<double> squares(std::uint32_t n, std::uint32_t left_out, double moved = 0) {
    std::vector<Point<double>> points;
    std::vector<test::Indices> triangles;
    for (std::uint32_t i = 0; i < (n + 1) * (n + 1); ++i) {
        points.emplace_back(i % (n + 1), i / (n + 1));
    }
    points.back().x() += moved;
    for (std::uint32_t i = 0; i < n * n; ++i) {
        const std::uint32_t low = i / n * (n + 1) + i % n;
        if (i != left_out) {
            triangles.push_back({low, low + 1, low + n + 2});
            triangles.push_back({low, low + n + 2, low + n + 1});
        }
    }
    return test::build<double>(points, triangles, std::vector<Phase>(triangles.size(), 0));
}

TEST(FluidOptions, TheDomainMayHaveAnyShape) {
    const double bit = std::nextafter(2.0, 3.0) - 2;
    for (const auto& complex :
         {squares(2, no_id), squares(2, 2), squares(3, 4), squares(2, no_id, bit),
          test::wheel<double>(4), test::hexagon<double>()}) {
        EXPECT_NO_THROW((void)Fluid(complex, {.phases = {{.phase = 0}}}));
    }
}

TEST(FluidOptions, AStepTakesTime) {
    fluid_scenes::Tank tank = fluid_scenes::static_drop(0.2, 1);
    for (const double bad : {0.0, -1.0, infinity, not_a_number}) {
        EXPECT_THROW((void)tank.fluid.step(tank.simulation, bad), InputError);
    }
    EXPECT_EQ(tank.fluid.time(), 0);
}

TEST(FluidOptions, ASimulationOfAnotherComplexIsRefused) {
    const std::vector<Shape> shapes{{fluid_scenes::disc({0.5, 0.5}, 0.25, 0.2), 1}};
    auto complex = initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = 0.2});
    auto other = complex;
    FluidOptions options;
    options.phases = {{.phase = 0}, {.phase = 1}};
    options.tensions = {{.tension = 1}};
    Fluid fluid(complex, options);
    Simulation<double> simulation(other, {.edge_length = 0.2});
    test::expect_refusal([&] { (void)fluid.step(simulation, 0.01); }, "Fluid::step",
                         "the simulation belongs to another complex");
    EXPECT_EQ(fluid.time(), 0);
}

// Truncated bytes, and those of a fluid in another mesh.
TEST(FluidArchives, AreReadWholeOrNotAtAll) {
    const auto complex_of = [](double h) {
        const std::vector<Shape> shapes{{fluid_scenes::disc({0.5, 0.5}, 0.25, h), 1}};
        return initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = h});
    };
    auto complex = complex_of(0.2);
    const auto other_complex = complex_of(0.15);
    FluidOptions options;
    options.phases = {{.phase = 0}, {.phase = 1}};
    options.tensions = {{.tension = 1}};
    const auto bytes_of = [](Fluid& fluid) {
        Archive archive;
        fluid.archive(archive);
        return archive.bytes();
    };
    Fluid fluid(complex, options);
    Fluid other(other_complex, options);
    const std::string at_rest = bytes_of(fluid);
    Simulation<double> simulation(complex, {.edge_length = 0.2});
    (void)fluid.step(simulation, 0.01);
    const std::string before = bytes_of(fluid);
    std::vector<std::string> wrong{bytes_of(other)};
    for (std::size_t i = 0; i < 50; ++i) {
        wrong.push_back(before.substr(0, i * before.size() / 50));
        wrong.push_back(at_rest.substr(0, i * at_rest.size() / 50));
    }
    for (const std::string& bytes : wrong) {
        Archive archive(bytes, "a file");
        EXPECT_THROW(fluid.archive(archive), FileError);
        EXPECT_EQ(bytes_of(fluid), before);
    }
}

} // namespace
} // namespace dsc::fluid_options_test
