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

Polygon channel_with_cylinder() {
    Points hole = circle(0.25, 24);
    for (Point<double>& p : hole) {
        p += Point<double>(0.7, 0.5);
    }
    return {{{0, 0}, {3, 0}, {3, 1}, {0, 1}}, {hole}};
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

INSTANTIATE_TEST_SUITE_P(
    InDomains, Rest,
    testing::Values(Case{"disc", {circle(1, 200)}},
                    Case{"ring", {circle(1, 200), {circle(0.4, 80)}}},
                    Case{"l", {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}},
                    Case{"turned", turned_rectangle(2)}, Case{"cylinder", channel_with_cylinder()}),
    [](const auto& each) { return each.param.name; });

std::vector<DomainEdge> edges_of(const Polygon& domain, const std::vector<std::string>& names) {
    std::vector<DomainEdge> edges;
    for (std::size_t i = 0; i < names.size(); ++i) {
        edges.push_back(
            {domain.outline[i], domain.outline[(i + 1) % domain.outline.size()], names[i]});
    }
    return edges;
}

// The exact flow in a channel, with an inflow and outflows by name, drags along both walls.
TEST(FluidDomains, SidesHaveConditionsAndForcesByName) {
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

// The force on a body in a fluid at rest is the weight of the fluid that it displaces.
TEST(FluidDomains, ABodyIsBuoyant) {
    const Polygon domain = channel_with_cylinder();
    Complex<double> complex = mesh_of(domain, 0.15);
    Simulation<double> simulation(complex, {.edge_length = 0.15});
    FluidOptions options = one_fluid();
    options.phases[0].density = 3;
    options.gravity = {0, -2};
    options.sides = {{.name = "other"}};
    Fluid fluid(complex, options);
    EXPECT_EQ(fluid.force_on("other"), Point<double>(0, 0)) << "before the first step";
    (void)fluid.step(simulation, 0.1);
    double area = 3;
    for (const Triangle t : triangles(complex)) {
        area -= dsc::area(complex, t);
    }
    EXPECT_NEAR((fluid.force_on("other") - Point<double>(0, 3 * 2 * area)).norm(), 0, 1e-11);
}

// Where a moving side meets one at rest, the corner rests; where it meets one that slips, nothing
// flows through that one.
TEST(FluidDomains, CornersOfMovingSides) {
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

// The inner of two cylinders rotates: u = A r + B / r. The root mean square of the error.
double error_between_cylinders(double h, FluidEquations equations) {
    const auto count = [h](double radius) {
        return static_cast<int>(std::lround(2 * pi * radius / h));
    };
    Complex<double> complex = mesh_of({circle(1, count(1)), {circle(0.5, count(0.5))}}, 1.02 * h);
    FluidOptions options = one_fluid();
    options.equations = equations;
    options.wall_velocity = [](const Point<double>& p, double) {
        return p.norm() < 0.75 ? Point<double>(-p.y(), p.x()) : Point<double>(0, 0);
    };
    Fluid fluid(complex, options);
    if (equations == FluidEquations::navier_stokes) { // until it is steady
        Simulation<double> simulation(complex, {.edge_length = h});
        for (int step = 0; step < 20; ++step) {
            (void)fluid.step(simulation, 0.05);
        }
    }
    const MeshSnapshot& mesh = fluid.field().mesh;
    double sum = 0;
    double area = 0;
    for (const SnapshotTriangle& triangle : mesh.triangles) {
        for (const std::uint32_t node : triangle.nodes) {
            const Point<double> p = mesh.nodes[node];
            const double r = p.norm();
            const Point<double> exact = (1 / r - r) / (3 * r) * Point<double>(-p.y(), p.x());
            sum += dsc::area(mesh, triangle) *
                   (fluid.field().velocity[node] - exact).squaredNorm() / 6;
        }
        area += dsc::area(mesh, triangle);
    }
    return std::sqrt(sum / area);
}

TEST(FluidDomains, CouetteBetweenCylindersIsOfThirdOrder) {
    const std::array errors{error_between_cylinders(0.1, FluidEquations::stokes),
                            error_between_cylinders(0.05, FluidEquations::stokes),
                            error_between_cylinders(0.025, FluidEquations::stokes)};
    EXPECT_LT(errors[2], 1e-6);
    EXPECT_GT(std::log2(errors[0] / errors[2]) / 2, 2.8); // the fit to three
    EXPECT_LT(error_between_cylinders(0.1, FluidEquations::navier_stokes), 1e-4);
    EXPECT_LT(error_between_cylinders(0.05, FluidEquations::navier_stokes), 1e-5);
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
TEST(FluidDomains, DropsKeepTheirAreaBesideInflowAndOutflow) {
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
TEST(FluidDomains, PointsWithinAStraightSideAreVertices) {
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
TEST(FluidDomains, TheEndsOfASideWithinAStraightWallStay) {
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

// A front rotates with the fluid in half a ring whose curved sides slip. At the inner side the
// domain turns by 11.25 degrees between two edges, and by more where the front has passed.
TEST(FluidDomains, AFrontSlidesAlongCurvedSides) {
    constexpr double h = 0.1;
    Points ring;
    std::vector<std::string> names;
    for (const auto& [radius, pieces] : {std::pair(1.0, 31), std::pair(0.5, 16)}) {
        for (int i = 0; i <= pieces; ++i) {
            const double angle = radius == 1.0 ? pi * i / pieces : pi * (pieces - i) / pieces;
            ring.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
            names.emplace_back("slippery");
        }
        names.back() = radius == 1.0 ? "outlet" : "inlet";
    }
    const Polygon domain(ring);
    const std::vector<Shape> behind{{{{0, 0}, {3, 0.9}, {3, -1}, {0, -1}}, 1}};
    Complex<double> complex = mesh_of(domain, h, behind);
    Simulation<double> simulation(complex, {.edge_length = h});
    FluidOptions options;
    options.phases = {{.phase = 0}, {.phase = 1}};
    options.tensions = {{.tension = 0}};
    options.equations = FluidEquations::stokes;
    options.domain_edges = edges_of(domain, names);
    options.sides = {
        {.name = "slippery", .wall = Wall::slip},
        {.name = "inlet", .inflow = [](const Point<double>& p, double) { return p.x(); }},
        {.name = "outlet", .wall = Wall::open}};
    Fluid fluid(complex, options);
    const double area = phase_area(complex, 1);
    for (int step = 0; step < 100; ++step) {
        EXPECT_EQ(fluid.step(simulation, 0.02).moved.unreached, 0U) << "step " << step;
    }
    EXPECT_NEAR(phase_area(complex, 1), area + 2 * 0.375, 1e-2);
    EXPECT_EQ(validate(complex).problem, "");
}

} // namespace
} // namespace dsc::domains_test
