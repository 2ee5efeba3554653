// SPDX-License-Identifier: MIT
// Fluids in domains of any shape: walls on oblique and curved sides, inflow and outflow.
#include "fluid/scenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace dsc::domains_test {
namespace {

using std::numbers::pi;
using Points = std::vector<Point<double>>;

Points circle(double radius, int n) {
    Points points;
    for (int i = 0; i < n; ++i) {
        points.emplace_back(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n));
    }
    return points;
}

constexpr double slope = 0.3; // rotation of the domains, in radians
Point<double> turned(double x, double y) {
    return {std::cos(slope) * x - std::sin(slope) * y, std::sin(slope) * x + std::cos(slope) * y};
}
Point<double> turned_back(const Point<double>& p) {
    return {std::cos(slope) * p.x() + std::sin(slope) * p.y(),
            -std::sin(slope) * p.x() + std::cos(slope) * p.y()};
}
Polygon turned_rectangle(double length) {
    return {{turned(0, 0), turned(length, 0), turned(length, 1), turned(0, 1)}};
}

Complex<double> mesh_of(const Polygon& domain, double h, const std::vector<Shape>& shapes = {}) {
    return initial_complex<double>(domain, shapes, {.edge_length = h});
}

FluidOptions one_fluid() {
    FluidOptions options;
    options.phases = {{.phase = 0}};
    return options;
}

double largest_velocity(const Fluid& fluid) {
    double largest = 0;
    for (const Point<double>& velocity : fluid.field().velocity) {
        largest = std::max(largest, velocity.norm());
    }
    return largest;
}

struct Case {
    const char* name;
    Polygon domain;
};

class Rest : public testing::TestWithParam<Case> {};

TEST_P(Rest, FluidsUnderGravityStayAtRest) {
    constexpr double h = 0.1;
    for (const bool has_layers : {false, true}) {
        for (const Wall wall : {Wall::no_slip, Wall::slip}) {
            std::vector<Shape> layer;
            if (has_layers) {
                layer = {{{{-9, -9}, {9, -9}, {9, 0.3}, {-9, 0.3}}, 1}};
            }
            Complex<double> complex = mesh_of(GetParam().domain, h, layer);
            Simulation<double> simulation(complex, {.edge_length = h});
            FluidOptions options;
            options.phases = {{.phase = 0, .viscosity = 0.1},
                              {.phase = 1, .density = 2, .viscosity = 0.1}};
            options.tensions = {{.tension = 0.1}};
            options.gravity = {0, -1};
            options.walls = {wall, wall, wall, wall, wall};
            options.tensions.front().contact_angle = 90;
            if (has_layers) { // a level interface meets oblique walls at other angles
                options.tensions.front().tension = 0;
            }
            Fluid fluid(complex, options);
            for (int step = 0; step < 3; ++step) {
                (void)fluid.step(simulation, 0.1);
                EXPECT_LT(largest_velocity(fluid), 1e-12)
                    << "layers " << has_layers << ", slip " << (wall == Wall::slip);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(InDomains, Rest,
                         testing::Values(Case{"disc", {circle(1, 200)}},
                                         Case{"ring", {circle(1, 200), {circle(0.4, 80)}}},
                                         Case{"l",
                                              {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}},
                                         Case{"turned", turned_rectangle(2)}),
                         [](const auto& each) { return each.param.name; });

// A parabolic inflow, and no stress at the outlet: exact with quadratic velocities.
TEST(FluidDomains, PoiseuilleInATurnedChannel) {
    const auto profile = [](const Point<double>& place) {
        const Point<double> at = turned_back(place);
        return Point<double>(at.y() * (1 - at.y()) * turned(1, 0));
    };
    const Complex<double> complex = mesh_of(turned_rectangle(3), 0.15);
    FluidOptions options = one_fluid();
    options.equations = FluidEquations::stokes;
    options.wall_velocity = [&](const Point<double>& place, double) { return profile(place); };
    const Fluid closed(complex, options); // the outlet has the same profile
    const FluidField& field = closed.field();
    for (std::size_t i = 0; i < field.mesh.nodes.size(); ++i) {
        if (i >= field.mesh.vertex_bound || complex.is_alive(Vertex{static_cast<unsigned>(i)})) {
            EXPECT_NEAR((field.velocity[i] - profile(field.mesh.nodes[i])).norm(), 0, 1e-11);
        }
    }
    // Without stress at the outlet, the flow spreads a little there, but not upstream.
    options.wall_at = [](const Point<double>& middle) {
        return turned_back(middle).x() > 3 - 1e-9 ? Wall::open : Wall::no_slip;
    };
    const Fluid open(complex, options);
    const auto at = [&](double x, double y) {
        const Point<double> place = turned(x, y);
        return Point<double>(velocity_at(open.field(), find_spot(open.field().mesh, place, 0)) -
                             profile(place));
    };
    EXPECT_LT(at(1, 0.4).norm(), 2e-4);
    EXPECT_LT(at(2, 0.5).norm(), 2e-2);
}

// The inner of two cylinders rotates: u = A r + B / r.
double error_between_cylinders(double h) {
    const auto count = [h](double radius) {
        return static_cast<int>(std::lround(2 * pi * radius / h));
    };
    const Complex<double> complex =
        mesh_of({circle(1, count(1)), {circle(0.5, count(0.5))}}, 1.02 * h);
    FluidOptions options = one_fluid();
    options.equations = FluidEquations::stokes;
    options.wall_velocity = [](const Point<double>& p, double) {
        return p.norm() < 0.75 ? Point<double>(-p.y(), p.x()) : Point<double>(0, 0);
    };
    const Fluid fluid(complex, options);
    double error = 0;
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v);
        const double r = p.norm();
        const double speed = (1 / r - r) / 3;
        error = std::max(
            error,
            (fluid.field().velocity[v.id] - Point<double>(-p.y(), p.x()) * speed / r).norm());
    }
    return error;
}

TEST(FluidDomains, CouetteBetweenCylindersIsOfSecondOrder) {
    const double coarse = error_between_cylinders(0.1);
    const double fine = error_between_cylinders(0.05);
    EXPECT_LT(fine, 1.5e-3);
    EXPECT_LT(fine, coarse / 3);
}

// A cylinder rotates in a fluid whose outer wall slips: the whole fluid rotates with it.
TEST(FluidDomains, SlipOnACurvedSideIsWithoutFriction) {
    const Complex<double> complex = mesh_of({circle(1, 64), {circle(0.5, 32)}}, 0.1);
    FluidOptions options = one_fluid();
    options.equations = FluidEquations::stokes;
    options.wall_velocity = [](const Point<double>& p, double) {
        return Point<double>(-p.y(), p.x());
    };
    options.wall_at = [](const Point<double>& p) {
        return p.norm() < 0.75 ? Wall::no_slip : Wall::slip;
    };
    const Fluid fluid(complex, options);
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v);
        EXPECT_NEAR((fluid.field().velocity[v.id] - Point<double>(-p.y(), p.x())).norm(), 0, 1e-11);
    }
}

// A front moves down a channel; the area of the fluid behind it grows by the inflow.
TEST(FluidDomains, WhatFlowsInIsPartOfTheArea) {
    constexpr double h = 0.1;
    const std::vector<Shape> behind{
        {{turned(-9, -9), turned(0.5, -9), turned(0.5, 9), turned(-9, 9)}, 1}};
    Complex<double> complex = mesh_of(turned_rectangle(2), h, behind);
    Simulation<double> simulation(complex, {.edge_length = h});
    FluidOptions options;
    options.phases = {{.phase = 0}, {.phase = 1, .density = 3}};
    options.tensions = {{.tension = 0}};
    options.equations = FluidEquations::stokes;
    options.wall_velocity = [](const Point<double>&, double) { return turned(1, 0); };
    options.wall_at = [](const Point<double>& middle) {
        const Point<double> at = turned_back(middle);
        return at.x() < 1e-9 ? Wall::no_slip : at.x() > 2 - 1e-9 ? Wall::open : Wall::slip;
    };
    Fluid fluid(complex, options);
    for (int step = 0; step < 20; ++step) {
        EXPECT_EQ(fluid.step(simulation, 0.02).moved.unreached, 0U);
    }
    EXPECT_NEAR(phase_area(complex, 1), 0.9, 1e-9);
}

} // namespace
} // namespace dsc::domains_test
