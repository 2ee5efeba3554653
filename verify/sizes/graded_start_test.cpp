// SPDX-License-Identifier: MIT
// The first complex with edges that grow away from the interface: as good as the uniform one,
// small, and good enough that the first step changes little.
#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"

#include "support/simulation_testing.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/passes/mesh/size_update.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "dsc/sizes/sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc::graded_start_test {
namespace {

constexpr double h = 0.01;

template <class Real>
Complex<Real> disc(const SizeOptions<double>& sizes, double length = h) {
    const int n = static_cast<int>(std::ceil(2 * std::numbers::pi * 0.15 / length));
    const std::vector<Shape> shapes{{test::circle_points({0.5, 0.75}, 0.15, n), 1}};
    return initial_complex<Real>({}, shapes, {.edge_length = length, .sizes = sizes});
}

double smallest_angle(const Complex<double>& complex) {
    double smallest = 180;
    for (const Triangle t : triangles(complex)) {
        const auto [a, b, c] = complex.vertices_of(t);
        smallest =
            std::min(smallest, min_angle_deg<double>(complex.position(a), complex.position(b),
                                                     complex.position(c)));
    }
    return smallest;
}

double median_quality(const Complex<double>& complex) {
    std::vector<double> list;
    for (const Triangle t : triangles(complex)) {
        const auto v = complex.vertices_of(t);
        list.push_back(quality<double>(complex.position(v[0]), complex.position(v[1]),
                                       complex.position(v[2])));
    }
    std::ranges::nth_element(list, list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2));
    return list[list.size() / 2];
}

TEST(GradedStart, HasAsManyTrianglesAsItsTargetsCallFor) {
    const auto count = [](double growth, double length) {
        return disc<double>({.growth = growth}, length).triangle_count();
    };
    EXPECT_LT(count(1.3, h / 2), 5000U); // 92,603 of one length
    EXPECT_GT(count(1.3, h / 2), 2000U);
    EXPECT_LT(count(2, h), count(1.3, h));
    EXPECT_LT(count(1.3, h), count(1.1, h));
    // Nearly all triangles are near the curve, so their number grows little faster than 1 / h.
    EXPECT_LT(count(1.3, h / 2), 2.5 * count(1.3, h));
}

TEST(GradedStart, IsOfGoodQuality) {
    for (const double growth : {1.1, 1.3, 1.6, 2.0}) {
        const Complex<double> complex = disc<double>({.growth = growth});
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_GE(smallest_angle(complex), 20) << growth;
        // If the length doubles from one edge to the next, triangles cannot be equilateral.
        EXPECT_GE(median_quality(complex), growth < 1.5 ? 0.82 : 0.74) << growth;
        EXPECT_TRUE(complex.attributes.empty());
    }
}

TEST(GradedStart, KeepsTheInterface) {
    const Complex<double> graded = disc<double>({.growth = 1.3});
    const Complex<double> uniform = disc<double>({});
    EXPECT_NEAR(phase_area(graded, 1), phase_area(uniform, 1), 1e-15);
    Complex<double> one = graded;
    Complex<double> other = uniform;
    EXPECT_EQ(Simulation<double>(one, {.edge_length = h}).interface_size(),
              Simulation<double>(other, {.edge_length = h}).interface_size());
}

TEST(GradedStart, LeavesTheFirstStepNothingToMend) {
    Complex<double> complex = disc<double>({.growth = 1.3});
    Options<double> options = test::options_for<double>(h);
    options.sizes.growth = 1.3;
    measure_sizes(complex, options.sizes, h, 0.0);
    // Vertices of the interface must stay, however short the edges at them are.
    const double free = complex.vertex_count() - 95.0;
    EXPECT_LT(static_cast<double>(out_of_size(complex, options).size()) - 95.0, free / 8);
    Simulation<double> simulation(complex, options);
    const auto report = simulation.step(test::constant<double>(1e-9, 0), 0, 1);
    EXPECT_LT(static_cast<double>(report.operations.splits + report.operations.collapses),
              free / 20);
}

TEST(GradedStart, FollowsThePlace) {
    const SizeOptions<double> sizes{.growth = 1.5,
                                    .by_place = [](const Point<double>& p, double, Phase) {
                                        return p.x() < 0.5 ? 0.02 : 0.08;
                                    }};
    const Complex<double> complex = disc<double>(sizes);
    EXPECT_EQ(validate(complex).problem, "");
    std::array<double, 2> count{};
    for (const Triangle t : triangles(complex)) {
        const auto v = complex.vertices_of(t);
        const double x = complex.position(v[0]).x();
        if (x < 0.3 || x > 0.7) {
            ++count[x < 0.5 ? 0 : 1];
        }
    }
    EXPECT_GT(count[0], 5 * count[1]);
}

// A curve ends on a side of the domain. Its edges there have a fiftieth of the edge length, and
// grow along the curve. The mesh of both phases must be as fine around that end, also along the
// side.
TEST(GradedStart, SidesAreAsFineAsTheInterfaceThatEndsThere) {
    const Point<double> tip(0.5, 0);
    const auto length_at = [&](const Point<double>& p, double) {
        return std::min(2 * h, h / 50 + 0.2 * (p - tip).norm());
    };
    Curve curve{.points = {}, .left = 1, .right = exterior_phase};
    for (double angle = 0; angle < std::numbers::pi / 2 - h;) {
        curve.points.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle));
        angle += 0.99 * length_at(curve.points.back(), 0) / 0.5;
    }
    curve.points.emplace_back(0, 0.5);
    const SizeOptions<double> sizes{.growth = 1.3, .shortest = h / 50, .on_interface = length_at};
    Complex<double> complex = initial_complex<double>({}, std::vector<Curve>{curve},
                                                      {.edge_length = 2 * h, .sizes = sizes});
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_GE(smallest_angle(complex), 20);
    int at_tip = 0;
    for (const Edge e : edges(complex)) {
        const auto [a, b] = complex.vertices_of(e);
        if (complex.position(a) == tip || complex.position(b) == tip) {
            ++at_tip;
            EXPECT_LT((complex.position(a) - complex.position(b)).norm(), h / 15);
        }
    }
    EXPECT_GE(at_tip, 3);

    const std::size_t before = complex.vertex_count();
    Options<double> options = test::options_for<double>(2 * h);
    options.sizes = sizes;
    options.interface.longest = 1.05;
    Simulation<double> simulation(complex, options);
    simulation.step(test::constant<double>(0, 1e-12), 0, 1);
    EXPECT_NEAR(static_cast<double>(complex.vertex_count()), static_cast<double>(before),
                0.1 * static_cast<double>(before))
        << "a step keeps them";
}

TEST(GradedStart, BadSizesAreRefused) {
    EXPECT_THROW(disc<double>({.growth = 3}), InputError);
    EXPECT_THROW(disc<double>({.growth = 1.3, .longest = h / 3}), InputError);
    EXPECT_THROW(disc<double>({.growth = 1.3, .shortest = 2 * h}), InputError);
}

} // namespace
} // namespace dsc::graded_start_test
