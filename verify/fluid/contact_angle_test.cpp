// SPDX-License-Identifier: MIT
// Drops on a wall, against the cap of a disc that meets the wall at the given contact angle.
#include "fluid/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dsc::contact_angle_test {
namespace {

using std::numbers::pi;

struct Cap {
    double height;
    double half_width;
};

Cap exact_cap(double area, double degrees) {
    const double angle = degrees * pi / 180;
    const double radius = std::sqrt(area / (angle - std::sin(angle) * std::cos(angle)));
    return {radius * (1 - std::cos(angle)), radius * std::sin(angle)};
}

// The final drop that a half disc of phase 1 on a wall becomes, relative to the exact cap.
Cap relative_cap(double degrees, double edge_length, bool in_void) {
    constexpr double radius = 0.4;
    std::vector<Point<double>> arc;
    const int n = static_cast<int>(std::ceil(pi * radius / edge_length));
    for (int i = 0; i <= n; ++i) {
        arc.emplace_back(1 + radius * std::cos(pi * i / n), radius * std::sin(pi * i / n));
    }
    arc.back().y() = 0;
    const std::vector<Curve> curves{{.points = arc, .left = 1, .right = 0}};
    Options<double> options;
    options.edge_length = edge_length;
    options.sizes.growth = 1.3;
    options.sizes.longest = 0.2;
    options.interface.longest = 1.05;
    Complex<double> complex = initial_complex<double>(
        {{0, 0}, {2, 1}}, curves, {.edge_length = edge_length, .sizes = options.sizes});
    Simulation<double> simulation(complex, options);
    FluidOptions fluids;
    fluids.phases = {{.phase = 0, .viscosity = 0.1, .is_void = in_void}, {.phase = 1}};
    fluids.tensions = {{.tension = 1, .contact_angle = degrees}};
    fluids.walls = {Wall::slip, Wall::slip, Wall::slip, Wall::slip};
    fluids.equations = FluidEquations::stokes;
    Fluid fluid(complex, fluids);
    for (int step = 0; step < 16; ++step) {
        (void)fluid.step(simulation, 0.5);
    }
    Cap cap{0, 0};
    double left = 2;
    double right = 0;
    for (const SnapshotEdge& edge : fluid.field().mesh.interface) {
        for (const std::uint32_t end : {edge.from, edge.to}) {
            const Point<double>& p = fluid.field().mesh.nodes[end];
            cap.height = std::max(cap.height, p.y());
            left = p.y() == 0 ? std::min(left, p.x()) : left;
            right = p.y() == 0 ? std::max(right, p.x()) : right;
        }
    }
    const Cap exact = exact_cap(phase_area(complex, 1), degrees);
    return {cap.height / exact.height, (right - left) / 2 / exact.half_width};
}

TEST(FluidContactAngle, DropsEndAsTheCapOfTheirAngle) {
    for (const double degrees : {60.0, 120.0}) {
        const Cap cap = relative_cap(degrees, 0.025, false);
        EXPECT_NEAR(cap.height, 1, 1e-3) << degrees << " degrees";
        EXPECT_NEAR(cap.half_width, 1, 1e-3) << degrees << " degrees";
    }
}

TEST(FluidContactAngle, TheSameWithNothingAroundThem) {
    const Cap cap = relative_cap(60, 0.05, true);
    EXPECT_NEAR(cap.height, 1, 2e-3);
    EXPECT_NEAR(cap.half_width, 1, 2e-3);
}

} // namespace
} // namespace dsc::contact_angle_test
