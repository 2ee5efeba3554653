// SPDX-License-Identifier: MIT
// Hard cases: coordinates near the limits of doubles, domains far from the origin, steps of many
// edge lengths, velocities that are not finite, and films thinner than an edge.
#include "dsc3/space_testing.h"
#include "support/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace dsc3::test::hard_test {
namespace {

constexpr double h = 1.0 / 12;
const int steps = dsc::test::are_asked_for("few") ? 3 : 12;

// Two balls, of which one is in two phases and ends on a side, in a flow along the sides; all
// lengths times `unit`, and the domain moved by `offset` of its sides.
Complex moved(double unit, double offset) {
    const Point low = Point::Constant(offset * unit);
    const auto at = [&](double x, double y, double z) {
        return Point(low + unit * Point(x, y, z));
    };
    const std::vector<Shape> shapes{{ball(at(0.35, 0.36, 0), 0.25 * unit), 1},
                                    {[&, p = at(0.35, 0.36, 0)](const Point& q) {
                                         return 0.8 * (q - p).x() - 0.6 * (q - p).y();
                                     },
                                     1,
                                     {{1, 2}}},
                                    {ball(at(0.6, 0.55, 0.65), 0.2 * unit), 3}};
    Complex complex =
        initial_complex({low, low + Point::Constant(unit)}, shapes, {.edge_length = h * unit});
    Simulation simulation(complex, {.edge_length = h * unit});
    std::uint64_t unreached = 0;
    for (int k = 0; k < steps; ++k) {
        unreached += simulation
                         .step(
                             [&](std::span<const Point> p, double, std::span<Point> v) {
                                 std::vector<Point> q;
                                 for (const Point& each : p) {
                                     q.emplace_back((each - low) / unit);
                                 }
                                 swirl(q, 0, v);
                                 for (Point& each : v) {
                                     each *= unit;
                                 }
                             },
                             0, 0.5 * h)
                         .unreached;
    }
    EXPECT_EQ(unreached, 0U);
    const ValidationReport report = validate(complex);
    EXPECT_TRUE(report.ok()) << report.problem;
    return complex;
}

TEST(Hard3, PowersOfTwoOfAllLengthsScaleTheBits) {
    const Complex one = moved(1, 0);
    for (const int power : {-100, -30, 30, 100}) {
        const double unit = std::ldexp(1.0, power);
        Complex other = moved(unit, 0);
        for (VertexRecord& vertex : other.vertices) {
            vertex.position /= unit;
        }
        EXPECT_EQ(mesh_hash(other), mesh_hash(one)) << "2^" << power;
    }
}

TEST(Hard3, DomainsFarFromTheOrigin) {
    const double volume = phase_volume(moved(1, 0), 3);
    for (const double offset : {-1e3, 1e6, 1e9}) {
        EXPECT_NEAR(phase_volume(moved(1, offset), 3) / volume, 1, 0.01) << offset;
    }
}

TEST(Hard3, StepsOfManyEdgesAndVelocitiesThatAreNotFinite) {
    Complex complex = initial_complex({}, {{ball({0.3, 0.5, 0.5}, 0.2), 1}}, {.edge_length = h});
    Simulation simulation(complex, {.edge_length = h});
    const double before = phase_volume(complex, 1);
    const StepReport far = simulation.step(
        [](std::span<const Point> p, double, std::span<Point> v) {
            std::fill(v.begin(), v.begin() + std::ptrdiff_t(p.size()), Point(0.4, 0, 0));
        },
        0, 1);
    EXPECT_EQ(far.unreached, 0U);
    EXPECT_GT(far.sub_steps, 10U);
    EXPECT_NEAR(phase_volume(complex, 1) / before, 1, 0.01);
    const StepReport held = simulation.step(
        [](std::span<const Point> p, double, std::span<Point> v) {
            for (std::size_t i = 0; i < p.size(); ++i) {
                v[i] = Point(i % 7 == 0 ? std::nan("") : 0.1, 0, 0);
            }
        },
        0, 0.01);
    EXPECT_GT(held.held, 0U);
    const StepReport fast = simulation.step(
        [](std::span<const Point> p, double, std::span<Point> v) {
            std::fill(v.begin(), v.begin() + std::ptrdiff_t(p.size()), Point(1e150, 0, 0));
        },
        0, 1);
    EXPECT_EQ(fast.gave_up, GiveUp::too_many_sub_steps);
    const ValidationReport report = validate(complex);
    EXPECT_TRUE(report.ok()) << report.problem;
}

// Two boxes that approach each other to a fortieth of an edge, and part.
TEST(Hard3, FilmsThinnerThanAnEdge) {
    const auto slab = [](double low, double high) {
        return box({{0.2, 0.2, low}, {0.8, 0.8, high}});
    };
    Complex complex =
        initial_complex({}, {{slab(0.2, 0.4), 1}, {slab(0.6, 0.8), 2}}, {.edge_length = h});
    const double one = phase_volume(complex, 1);
    const double two = phase_volume(complex, 2);
    Simulation simulation(complex, {.edge_length = h});
    const int n = 2 * steps;
    std::uint64_t unreached = 0;
    for (int k = 0; k < n; ++k) {
        unreached += simulation
                         .step(
                             [&](std::span<const Point> p, double t, std::span<Point> v) {
                                 const double gap = 0.2 - 0.198 * (1 - std::abs(1 - 2 * t));
                                 const double speed = t < 0.5 ? -2 * 0.198 : 2 * 0.198;
                                 for (std::size_t i = 0; i < p.size(); ++i) {
                                     v[i] = Point(0, 0, p[i].z() > 0.4 + gap / 2 ? speed : 0);
                                 }
                             },
                             double(k) / n, 1.0 / n)
                         .unreached;
        const ValidationReport report = validate(complex);
        ASSERT_TRUE(report.ok()) << report.problem;
    }
    EXPECT_EQ(unreached, 0U);
    EXPECT_NEAR(phase_volume(complex, 1) / one, 1, 0.03);
    EXPECT_NEAR(phase_volume(complex, 2) / two, 1, 0.03);
}

} // namespace
} // namespace dsc3::test::hard_test
