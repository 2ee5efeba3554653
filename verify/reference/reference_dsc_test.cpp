// SPDX-License-Identifier: MIT
// The literal method of reference/: movement, integrators, and short runs of algorithm 5.1. Its
// operations are compared with the library's, and whole runs by the gate.
#include "dsc/base/error.h"
#include "dsc/base/types.h"
#include "reference/algorithm/dsc.h"
#include "reference/algorithm/quality.h"
#include "reference/complex/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace dsc::reference::reference_dsc_test {
namespace {

using Points = std::vector<Point<double>>;
using Triples = std::vector<std::array<std::uint32_t, 3>>;

Vertex operator""_v(unsigned long long id) { return Vertex{static_cast<std::uint32_t>(id)}; }

// Vertex 0 at the origin and 1 to 6 on the unit circle, counter-clockwise from angle 0.
Complex fan() {
    const double s = std::sqrt(0.75);
    const Points points{{0, 0}, {1, 0}, {.5, s}, {-.5, s}, {-1, 0}, {-.5, -s}, {.5, -s}};
    const Triples triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}};
    return make_complex(points, triangles, std::vector<Phase>(6, exterior_phase));
}

// n x n squares with diagonals from lower left to upper right; vertex (i, j) is j (n + 1) + i. The
// square (i, j) has phase 1 where `is_inside(i, j)`, and otherwise 0.
Complex grid(std::uint32_t n, double side,
             const std::function<bool(std::uint32_t, std::uint32_t)>& is_inside) {
    Points points;
    Triples triangles;
    std::vector<Phase> phases;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i)
            points.emplace_back(i * side, j * side);
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            triangles.push_back({a, a + 1, a + n + 2});
            triangles.push_back({a, a + n + 2, a + n + 1});
            phases.insert(phases.end(), 2, is_inside(i, j) ? Phase{1} : exterior_phase);
        }
    }
    return make_complex(points, triangles, phases);
}

// The unit square in 20 x 20 squares, of which those from `low` up to `high` in both directions
// have phase 1.
Complex square_in_square(std::uint32_t low, std::uint32_t high) {
    return grid(20, .05, [&](std::uint32_t i, std::uint32_t j) {
        return std::min(i, j) >= low && std::max(i, j) < high;
    });
}

double total_area(const Complex& K, Phase phase) {
    double sum = 0;
    for (const auto& [t, p] : K.phases())
        sum += p == phase ? area(K, t) : 0.0;
    return sum;
}

void expect_valid(const Complex& K) {
    for (const std::string& fault : validate(K))
        ADD_FAILURE() << fault;
}

// --- movement [5.1], integrators, interpolators [8.9] --------------------------------------------

TEST(ReferenceMovement, GoesAsFarAsNoTriangleInverts) { // figure 5.2
    Complex K = fan();
    EXPECT_TRUE(move_vertex(0_v, {0.3, 0.1}, K));
    EXPECT_EQ(K.coord(0_v), Point<double>(0.3, 0.1));
    Destinations under_way{{0_v, {3, 0}}};
    movement(under_way, K);
    EXPECT_EQ(under_way.size(), 1U);
    EXPECT_GT(K.coord(0_v).x(), 0.8);
    expect_valid(K);
    for (int i = 0; i < 200; ++i)
        movement(under_way, K);
    expect_valid(K); // the vertex approaches the domain boundary, but never crosses it
    K.set_coord(0_v, {0, 0});
    // The edge from 1 to 2 has length 1 and distance sqrt(3/4), of which all but 0.02 may be used.
    const double s = std::sqrt(0.75);
    EXPECT_NEAR(movable_fraction(K, 0_v, {2 * s * s, 2 * s * .5}), (1 - min_altitude / s) / 2,
                1e-12);
    EXPECT_EQ(movable_fraction(K, 0_v, {0.1, 0}), 1);
}

TEST(ReferenceIntegrators, HaveTheirOrders) {
    const Velocity turn = [](const Point<double>& p, double) {
        return Point<double>(-p.y(), p.x());
    };
    const auto error = [&](Integrator integrator, double dt) {
        return (advect(turn, {1, 0}, 0, dt, integrator) - Point<double>(std::cos(dt), std::sin(dt)))
            .norm();
    };
    for (const auto& [integrator, order] :
         {std::pair{Integrator::euler, 1}, {Integrator::midpoint, 2}, {Integrator::rk4, 4}}) {
        EXPECT_NEAR(std::log2(error(integrator, 0.2) / error(integrator, 0.1)), order + 1, 0.1);
    }
    const Velocity clock = [](const Point<double>&, double t) { return Point<double>(t, t * t); };
    const Point<double> p = advect(clock, {0, 0}, 1, 1, Integrator::rk4);
    EXPECT_NEAR(p.x(), 1.5, 1e-15);
    EXPECT_NEAR(p.y(), 7.0 / 3, 1e-15);
}

// --- the algorithm [5.6] -------------------------------------------------------------------------

struct Summary {
    std::size_t unreached = 0;
    StepCounts last;
};

Summary run(Complex& K, const Velocity& velocity, double dt, int steps, const Options& options) {
    Summary result;
    for (int i = 0; i < steps; ++i) {
        result.last = step(K, velocity, i * dt, dt, options);
        result.unreached += result.last.unreached;
    }
    expect_valid(K);
    return result;
}

Options with_edge_length(double h) {
    Options options;
    options.passes.edge_length = h;
    return options;
}

TEST(ReferenceDsc, FarStepsAreDivided) {
    Complex K = square_in_square(4, 10);
    const Velocity wind = [](const Point<double>&, double) { return Point<double>(.4, .1); };
    const Summary result = run(K, wind, 1, 1, with_edge_length(.05)); // 8 h
    EXPECT_EQ(result.unreached, 0U);
    EXPECT_GE(result.last.substeps, 16U);
    EXPECT_LE(result.last.substeps, 18U);
    EXPECT_NEAR(total_area(K, 1), .09, 1e-12);
    for (Vertex v : K.interface().vertices) {
        const Point<double> from_middle = K.coord(v) - Point<double>(.75, .45);
        EXPECT_NEAR(from_middle.cwiseAbs().maxCoeff(), .15, 1e-12);
    }
    EXPECT_THROW(step(K, wind, 0, 1e9, with_edge_length(.05)), InputError);
    EXPECT_THROW(step(K, wind, 0, std::nan(""), with_edge_length(.05)), InputError);
    EXPECT_THROW(step(K, wind, 0, 1, with_edge_length(0)), InputError);
}

TEST(ReferenceDsc, EndsWhereTheBoundaryEnds) {
    Complex K = square_in_square(4, 16);
    const Velocity wind = [](const Point<double>&, double) { return Point<double>(.05, 0); };
    Options options = with_edge_length(.05);
    options.max_iterations = 4;
    EXPECT_GT(run(K, wind, 1, 8, options).unreached, 0U);
    EXPECT_NEAR(total_area(K, 0) + total_area(K, 1), 1, 1e-12);
    // Figure 8.3: the ends of the water's surface slide along the domain boundary, and corners
    // stay.
    Complex water = grid(4, 1, [](std::uint32_t, std::uint32_t j) { return j == 0; });
    const Velocity up = [](const Point<double>&, double) { return Point<double>(.3, .3); };
    EXPECT_EQ(run(water, up, 1, 1, with_edge_length(1)).unreached, 0U);
    EXPECT_EQ(water.coord(0_v), Point<double>(0, 0));
    EXPECT_EQ(water.coord(5_v), Point<double>(0, 1.3));
    EXPECT_NEAR(total_area(water, 0) + total_area(water, 1), 16, 1e-12);
}

} // namespace
} // namespace dsc::reference::reference_dsc_test
