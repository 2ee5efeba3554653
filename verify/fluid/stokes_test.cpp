// SPDX-License-Identifier: MIT
// Flow without inertia, against an exact rate.
#include "fluid/scenes.h"

#include <gtest/gtest.h>

namespace dsc::stokes_test {
namespace {

// How much longer a phase is than high, by its second moments: 0 for a disc.
double elongation(const FluidField& field, Phase phase, const Point<double>& centre) {
    double difference = 0;
    double sum = 0;
    for (const FrozenTriangle& t : field.mesh.triangles) {
        if (t.phase != phase) {
            continue;
        }
        for (const std::size_t i : {3U, 4U, 5U}) { // the mean of the middles: exact for degree 2
            const Point<double> p = field.mesh.nodes[t.nodes[i]] - centre;
            difference += area(field.mesh, t) * (p.x() * p.x() - p.y() * p.y());
            sum += area(field.mesh, t) * p.squaredNorm();
        }
    }
    return difference / sum;
}

// At which rate an ellipse becomes round in the middle of a square, over that without walls:
// n sigma / (2 (mu_i + mu_o) R) for n = 2.
double relative_rate(double side, double edge_length) {
    const Point<double> centre(side / 2, side / 2);
    std::vector<Point<double>> outline = fluid_scenes::disc(centre, 1, edge_length);
    for (Point<double>& p : outline) {
        p = centre + Point<double>((p - centre).cwiseProduct(Point<double>(1.01, 1 / 1.01)));
    }
    const std::vector<Shape> ellipse{{outline, 1}};
    Options<double> options;
    options.edge_length = edge_length;
    options.sizes.growth = 1.3;
    FluidOptions fluids;
    fluids.phases = {{.phase = 0, .viscosity = 1}, {.phase = 1, .viscosity = 3}};
    fluids.tensions = {{.tension = 1}};
    fluids.walls = {Wall::slip, Wall::slip, Wall::slip, Wall::slip};
    fluids.equations = FluidEquations::stokes;
    fluid_scenes::Tank tank({{0, 0}, {side, side}}, ellipse, options, fluids);
    const double first = elongation(tank.fluid.field(), 1, centre);
    for (int step = 0; step < 10; ++step) {
        (void)tank.fluid.step(tank.simulation, 0.1);
    }
    const double last = elongation(tank.fluid.field(), 1, centre);
    return std::log(first / last) / tank.fluid.time() / (2.0 / (2 * (1 + 3)));
}

TEST(FluidStokes, AnEllipseBecomesRoundAtTheExactRate) {
    // The moments of a polygon change a little where its vertices slide along its curve: with edges
    // of 0.1 that is 8e-4 of the rate.
    const double near = relative_rate(16, 0.05);
    const double far = relative_rate(32, 0.05);
    // Walls slow it by the square of one over their distance.
    EXPECT_NEAR(far + (far - near) / 3, 1, 2e-3) << near << " and " << far;
    EXPECT_LT(near, far);
}

} // namespace
} // namespace dsc::stokes_test
