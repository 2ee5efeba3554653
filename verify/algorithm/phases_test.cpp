// SPDX-License-Identifier: MIT
// The driver where more than two phases meet, where they touch, and where the domain ends.
#include "dsc/algorithm/simulation.h"

#include "support/simulation_testing.h"

#include "dsc/complex/ranges.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace dsc::phases_test {
namespace {

using test::coarse;
using test::constant;
using test::disc_complex;
using test::expect_sound;
using test::options_for;
using test::pointwise;

template <class Real>
class Phases : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Phases, Reals);

// Three phases that meet in the middle and at the sides of the domain.
template <class Real>
Complex<Real> three_phases(double h) {
    auto complex = initial_complex<Real>({}, {}, {.edge_length = h});
    for (const Triangle t : triangles(complex)) {
        Point<Real> middle = Point<Real>::Zero();
        for (const Vertex v : complex.vertices_of(t)) {
            middle += complex.position(v) / Real(3);
        }
        const double angle = std::atan2(static_cast<double>(middle.y()) - 0.5,
                                        static_cast<double>(middle.x()) - 0.5);
        complex.set_phase(t, angle < -1 ? 0 : (angle < 1 ? 1 : 2));
    }
    return complex;
}

TYPED_TEST(Phases, CarriesAJunctionOfThreePhases) {
    using Real = TypeParam;
    auto complex = three_phases<Real>(coarse);
    const auto options = options_for<Real>(coarse);
    Simulation<Real> simulation(complex, options);
    expect_sound(complex, simulation);
    // A vortex that is zero at the sides.
    const auto velocity = pointwise<Real>([](const Point<double>& p, double) {
        constexpr double pi = std::numbers::pi;
        const double sx = std::sin(pi * p.x());
        const double sy = std::sin(pi * p.y());
        return Point<double>(sx * sx * std::sin(2 * pi * p.y()),
                             -sy * sy * std::sin(2 * pi * p.x()));
    });
    std::uint64_t unreached = 0;
    for (int step = 0; step < 60; ++step) {
        unreached += simulation.step(velocity, 0, Real(0.01)).unreached;
        expect_sound(complex, simulation);
    }
    EXPECT_EQ(unreached, 0U);
    std::array<double, 3> areas{};
    for (const Triangle t : triangles(complex)) {
        const auto [a, b, c] = complex.vertices_of(t);
        const Point<double> p = complex.position(a).template cast<double>();
        const Point<double> u = complex.position(b).template cast<double>() - p;
        const Point<double> w = complex.position(c).template cast<double>() - p;
        areas.at(complex.phase(t)) += (u.x() * w.y() - u.y() * w.x()) / 2;
    }
    for (const double area : areas) {
        EXPECT_GT(area, 0.2);
    }
    EXPECT_NEAR(areas[0] + areas[1] + areas[2], 1, 1e-6);
}

// Everything is driven against a side of the domain and along it.
TYPED_TEST(Phases, StopsAtTheSideOfTheDomain) {
    using Real = TypeParam;
    auto complex = disc_complex<Real>(coarse, {0.5, 0.3}, 0.2);
    const auto options = options_for<Real>(coarse);
    Simulation<Real> simulation(complex, options);
    std::uint64_t unreached = 0;
    for (int step = 0; step < 60; ++step) {
        unreached += simulation.step(constant<Real>(0.005, -0.01), 0, 1).unreached;
        expect_sound(complex, simulation);
    }
    EXPECT_GT(unreached, 0U);
    for (const Vertex v : vertices(complex)) {
        const Point<Real> p = complex.position(v);
        EXPECT_TRUE(p.minCoeff() >= 0 && p.maxCoeff() <= 1);
    }
}

// A phase that lies along a side of the domain is carried along it, and its boundary stays there.
TYPED_TEST(Phases, SlidesAlongTheSideOfTheDomain) {
    using Real = TypeParam;
    auto complex = initial_complex<Real>({}, {}, {.edge_length = coarse});
    for (const Triangle t : triangles(complex)) {
        bool inside = true;
        for (const Vertex v : complex.vertices_of(t)) {
            const Point<double> p = complex.position(v).template cast<double>();
            inside = inside && (p - Point<double>(0.4, 0)).norm() < 0.25;
        }
        complex.set_phase(t, inside ? 1 : 0);
    }
    const auto options = options_for<Real>(coarse);
    Simulation<Real> simulation(complex, options);
    expect_sound(complex, simulation);
    for (int step = 0; step < 40; ++step) {
        (void)simulation.step(constant<Real>(0.005, 0), 0, 1);
        expect_sound(complex, simulation);
    }
    double area = 0;
    for (const Triangle t : triangles(complex)) {
        const auto [a, b, c] = complex.vertices_of(t);
        const Point<double> p = complex.position(a).template cast<double>();
        const Point<double> u = complex.position(b).template cast<double>() - p;
        const Point<double> w = complex.position(c).template cast<double>() - p;
        area += (u.x() * w.y() - u.y() * w.x()) / 2;
    }
    EXPECT_NEAR(area, 1, 1e-6) << "the domain keeps its shape";
}

// Two discs are pressed against each other: they block each other, no one is lost.
TYPED_TEST(Phases, EndsWherePhasesTouch) {
    using Real = TypeParam;
    const std::vector<Shape> shapes{{test::circle_points({0.28, 0.5}, 0.15, 19), 1},
                                    {test::circle_points({0.72, 0.5}, 0.15, 19), 2}};
    auto complex = initial_complex<Real>({}, shapes, {.edge_length = coarse});
    const auto options = options_for<Real>(coarse);
    Simulation<Real> simulation(complex, options);
    const auto velocity = pointwise<Real>(
        [](const Point<double>& p, double) { return Point<double>(p.x() < 0.5 ? 1 : -1, 0); });
    std::uint64_t unreached = 0;
    for (int step = 0; step < 30; ++step) {
        const StepReport report = simulation.step(velocity, 0, Real(0.01));
        unreached += report.unreached;
        ASSERT_LE(report.passes, report.sub_steps * static_cast<std::uint32_t>(options.max_passes));
        expect_sound(complex, simulation);
    }
    EXPECT_GT(unreached, 0U);
}

} // namespace
} // namespace dsc::phases_test
