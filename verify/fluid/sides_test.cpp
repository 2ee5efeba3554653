// SPDX-License-Identifier: MIT
// Sides of domains by name: conditions, forces, inflow and outflow, and their ends.
#include "fluid/domains.h"

#include <gtest/gtest.h>

namespace dsc::sides_test {
namespace {

using namespace fluid_domains;

// The exact flow in a channel, with an inflow and outflows by name, drags along both walls.
TEST(FluidSides, SidesHaveConditionsAndForcesByName) {
    const Polygon domain = turned_rectangle(3);
    const Complex<double> complex = mesh_of(domain, 0.15);
    FluidOptions options = one_fluid();
    options.phases[0].viscosity = 0.5;
    options.equations = FluidEquations::stokes;
    options.domain_edges = edges_of(domain, {"floor", "outlet", "ceiling", "inlet"});
    const auto speed = [](const Point<double>& place, double) {
        const double y = turned_back(place).y();
        return y * (1 - y);
    };
    options.sides = {{.name = "inlet", .inflow = speed},
                     {.name = "outlet",
                      .inflow = [&](const Point<double>& p, double t) { return -speed(p, t); }},
                     {.name = "floor"},
                     {.name = "ceiling"}};
    const Fluid fluid(complex, options);
    const FluidField& field = fluid.field();
    for (const Vertex v : vertices(complex)) {
        const Point<double> wanted = speed(complex.position(v), 0) * turned(1, 0);
        EXPECT_NEAR((field.velocity[v.id] - wanted).norm(), 0, 1e-11);
    }
    // The mean of the pressure is 0, so nothing presses on the walls as a whole. The corner nodes
    // belong to the inlet and the outlet, which the pressure pushes outwards.
    const Point<double> walls = fluid.force_on("floor") + fluid.force_on("ceiling");
    const Point<double> ends = fluid.force_on("inlet") + fluid.force_on("outlet");
    EXPECT_NEAR(turned_back(walls + ends).norm(), 0, 1e-10);
    EXPECT_NEAR(turned_back(walls).x(), 2 * 0.5 * 3, 0.2);
    EXPECT_NEAR(turned_back(fluid.force_on("inlet")).x(), -0.5 * 2 * 1.5, 0.2);
}

// Where a moving side meets one at rest, the corner rests; where it meets one that slips, nothing
// flows through that one.
TEST(FluidSides, CornersOfMovingSides) {
    const Complex<double> complex =
        initial_complex<double>({{0, 0}, {1, 1}}, {}, {.edge_length = 0.2});
    FluidOptions options = one_fluid();
    options.equations = FluidEquations::stokes;
    options.sides = {
        {.name = "top", .velocity = [](const auto&, double) { return Point<double>(1, 0); }},
        {.name = "left", .wall = Wall::slip}};
    const Fluid lid(complex, options);
    options.sides[0] = {.name = "top", .inflow = [](const auto&, double) { return 1.0; }};
    options.sides.push_back({.name = "bottom", .wall = Wall::open});
    const Fluid inlet(complex, options);
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v);
        if (p.y() == 1) {
            const bool is_inside = p.x() > 0 && p.x() < 1;
            EXPECT_EQ(lid.field().velocity[v.id], Point<double>(is_inside ? 1 : 0, 0));
            EXPECT_EQ(inlet.field().velocity[v.id], Point<double>(0, p.x() < 1 ? -1 : 0));
        }
    }
}

// A front moves down a channel; the area of the fluid behind it grows by the inflow.
TEST(FluidSides, WhatFlowsInIsPartOfTheArea) {
    constexpr double h = 0.1;
    for (const bool is_by_name : {false, true}) {
        const std::vector<Shape> behind{
            {{turned(-9, -9), turned(0.5, -9), turned(0.5, 9), turned(-9, 9)}, 1}};
        Complex<double> complex = mesh_of(turned_rectangle(2), h, behind);
        Simulation<double> simulation(complex, {.edge_length = h});
        FluidOptions options;
        options.phases = {{.phase = 0}, {.phase = 1, .density = 3}};
        options.tensions = {{.tension = 0}};
        options.equations = FluidEquations::stokes;
        if (is_by_name) {
            options.domain_edges =
                edges_of(turned_rectangle(2), {"slippery", "outlet", "slippery", "inlet"});
            options.sides = {
                {.name = "slippery", .wall = Wall::slip},
                {.name = "outlet", .wall = Wall::open},
                {.name = "inlet", .inflow = [](const Point<double>&, double) { return 1.0; }}};
        } else {
            options.wall_velocity = [](const Point<double>&, double) { return turned(1, 0); };
            options.wall_at = [](const Point<double>& middle) {
                const Point<double> at = turned_back(middle);
                return at.x() < 1e-9 ? Wall::no_slip : at.x() > 2 - 1e-9 ? Wall::open : Wall::slip;
            };
        }
        Fluid fluid(complex, options);
        for (int step = 0; step < 20; ++step) {
            EXPECT_EQ(fluid.step(simulation, 0.02).moved.unreached, 0U);
        }
        EXPECT_NEAR(phase_area(complex, 1), 0.9, 1e-9) << "by name: " << is_by_name;
    }
}

// A drop behind a cylinder, and a layer along the wall that flows in at one end and out at the
// other one.
TEST(FluidSides, DropsKeepTheirAreaBesideInflowAndOutflow) {
    constexpr double h = 0.1;
    Points drop = circle(0.12, 12);
    for (Point<double>& p : drop) {
        p += Point<double>(1.2, 0.6);
    }
    const std::vector<Shape> shapes{{drop, 1}, {{{-9, -9}, {9, -9}, {9, 0.15}, {-9, 0.15}}, 2}};
    Complex<double> complex = mesh_of(channel_with_cylinder(), h, shapes);
    Simulation<double> simulation(complex, {.edge_length = h});
    FluidOptions options;
    options.phases = {{.phase = 0, .viscosity = 0.1},
                      {.phase = 1, .density = 2, .viscosity = 0.3},
                      {.phase = 2, .viscosity = 0.2}};
    options.tensions = {{.one = 0, .other = 1, .tension = 0.5},
                        {.one = 0, .other = 2, .tension = 0},
                        {.one = 1, .other = 2, .tension = 0}};
    options.sides = {
        {.name = "left",
         .inflow = [](const Point<double>& p, double) { return 4 * p.y() * (1 - p.y()); }},
        {.name = "right", .wall = Wall::open}};
    Fluid fluid(complex, options);
    const double area = phase_area(complex, 1);
    const double layer = phase_area(complex, 2);
    for (int step = 0; step < 25; ++step) {
        EXPECT_EQ(fluid.step(simulation, 0.02).moved.unreached, 0U);
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_NEAR(phase_area(complex, 1), area, 1e-13);
    }
    EXPECT_GT(cubic_outline(complex, 1).centroid.x(), 1.4) << "the drop moves";
    EXPECT_NEAR(phase_area(complex, 2) / layer, 1, 0.1);
}

// Points of the outline stay at the start, also on level sides, and are marked only at corners.
TEST(FluidSides, PointsWithinAStraightSideAreVertices) {
    const Polygon domain({{0, 0}, {0.3, 0}, {0.325, 0}, {2, 0}, {2, 1}, {0, 1}});
    const Complex<double> complex = mesh_of(domain, 0.1);
    for (const Point<double>& point : domain.outline) {
        bool is_there = false;
        for (const Vertex v : vertices(complex)) {
            if (complex.position(v) == point) {
                is_there = true;
                EXPECT_EQ(complex.is_boundary_feature(v), point.x() == 0 || point.x() == 2);
            }
        }
        EXPECT_TRUE(is_there) << point.x();
    }
}

// A jet through a gap in the floor bends a layer that flows along it, and remeshing moves, splits
// and merges the edges of the floor. The ends of the gap stay.
TEST(FluidSides, TheEndsOfASideWithinAStraightWallStay) {
    constexpr double h = 0.1;
    const Polygon domain(
        {turned(0, 0), turned(0.73, 0), turned(1.04, 0), turned(2, 0), turned(2, 1), turned(0, 1)});
    const std::vector<Shape> layer{
        {{turned(-9, -9), turned(9, -9), turned(9, 0.25), turned(-9, 0.25)}, 1}};
    Complex<double> complex = mesh_of(domain, h, layer);
    Simulation<double> simulation(complex, {.edge_length = h});
    FluidOptions options;
    options.phases = {{.phase = 0, .viscosity = 0.1}, {.phase = 1, .viscosity = 0.1}};
    options.tensions = {{.tension = 0.01}};
    options.domain_edges = edges_of(domain, {"wall", "jet", "wall", "outlet", "wall", "inlet"});
    options.sides = {{.name = "wall", .wall = Wall::slip},
                     {.name = "jet", .inflow = [](const Point<double>&, double) { return 0.3; }},
                     {.name = "inlet", .inflow = [](const Point<double>&, double) { return 1.0; }},
                     {.name = "outlet", .wall = Wall::open}};
    Fluid fluid(complex, options);
    for (int step = 0; step < 100; ++step) {
        EXPECT_EQ(fluid.step(simulation, 0.02).moved.unreached, 0U);
    }
    EXPECT_EQ(validate(complex).problem, "");
    for (const double end : {0.73, 1.04}) {
        double nearest = 9;
        for (const Vertex v : vertices(complex)) {
            nearest = std::min(nearest, (complex.position(v) - turned(end, 0)).norm());
        }
        EXPECT_LT(nearest, 1e-15) << "at " << end;
    }
}

} // namespace
} // namespace dsc::sides_test
