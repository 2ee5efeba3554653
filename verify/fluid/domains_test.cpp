// SPDX-License-Identifier: MIT
// Fluids in domains of any shape: walls on oblique and curved sides.
#include "fluid/domains.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace dsc::domains_test {
namespace {

using namespace fluid_domains;

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

// Stokes flow in a ring whose inner side slips and is cut into uneven edges. The stream function is
// f(r) cos(2 theta) with f = a r^2 + b / r^2 + c r^4 + d; on the inner side f and the shear stress,
// f'' - f' / r, are zero, and on the outer one f = 0, f' = 1. The root mean square of the error,
// and the largest on the inner side.
std::array<double, 2> errors_beside_slip(double h) {
    constexpr double inner = 0.4;
    const std::array<double, 4> powers{2, -2, 4, 0};
    Eigen::Matrix4d conditions;
    for (Eigen::Index i = 0; const double q : powers) {
        conditions.col(i++) << std::pow(inner, q), q * (q - 2) * std::pow(inner, q - 2), 1, q;
    }
    const Eigen::Vector4d factors = conditions.partialPivLu().solve(Eigen::Vector4d(0, 0, 0, 1));
    const auto exact = [&](const Point<double>& p) {
        const double r = p.norm();
        double f = 0;
        double slope_of_f = 0;
        for (Eigen::Index i = 0; const double q : powers) {
            f += factors[i] * std::pow(r, q);
            slope_of_f += factors[i++] * q * std::pow(r, q - 1);
        }
        const double angle = 2 * std::atan2(p.y(), p.x());
        return Point<double>((-2 * f / r * std::sin(angle) * p -
                              slope_of_f * std::cos(angle) * Point<double>(-p.y(), p.x())) /
                             r);
    };
    Points hole;
    const int count = static_cast<int>(std::lround(2 * pi * inner / h));
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * pi * (i + 0.2 * std::sin(37 * i)) / count;
        hole.emplace_back(inner * std::cos(angle), inner * std::sin(angle));
    }
    const Complex<double> complex =
        mesh_of({circle(1, static_cast<int>(std::lround(2 * pi / h))), {hole}}, 1.3 * h);
    FluidOptions options = one_fluid();
    options.equations = FluidEquations::stokes;
    options.wall_velocity = [&](const Point<double>& p, double) { return exact(p); };
    options.wall_at = [](const Point<double>& p) {
        return p.norm() < 0.75 ? Wall::slip : Wall::no_slip;
    };
    const Fluid fluid(complex, options);
    double sum = 0;
    double on_inner = 0;
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v);
        const double error = (fluid.field().velocity[v.id] - exact(p)).norm();
        sum += error * error / static_cast<double>(complex.vertex_count());
        on_inner = p.norm() < inner + 1e-9 ? std::max(on_inner, error) : on_inner;
    }
    return {std::sqrt(sum), on_inner};
}

TEST(FluidDomains, SlipOnUnevenEdgesOfACurvedSideIsOfSecondOrder) {
    const auto coarse = errors_beside_slip(0.05);
    const auto fine = errors_beside_slip(0.025);
    EXPECT_LT(fine[0], 3e-5);
    EXPECT_LT(fine[1], 3e-4);
    EXPECT_GT(std::log2(coarse[0] / fine[0]), 1.8);
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
