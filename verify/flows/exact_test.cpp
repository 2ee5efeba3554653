// SPDX-License-Identifier: MIT
// Velocity fields against their definitions, and exact shapes against closed forms, known lengths
// and their own statements of error.
#include "dsc/base/error.h"
#include "dsc/geometry/points.h"
#include "flows/exact.h"
#include "flows/sine_cosine.h"
#include "measures/symmetric_difference.h"
#include "shapes/shapes.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace dsc::scenes::exact_test {
namespace {

using std::numbers::pi;
using test::square;
using test::uniform;
using Random = std::mt19937_64;

TEST(SineCosine, AgreesWithExtendedPrecision) {
    Random random(8);
    std::vector<double> x{0.0, 0.25, 0.5, 0.75, 1.0, -0.5, -1.0, 1e-300, 2.5, 999.5, 1e6};
    for (const double scale : {0.3, 1.0, 1e3, 1e9}) {
        for (int i = 0; i < 20000; ++i) {
            x.push_back(uniform(random, -scale, scale));
        }
    }
    std::vector<double> sine(x.size());
    std::vector<double> cosine(x.size());
    sine_cosine_pi(x.data(), x.size(), sine.data(), cosine.data());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const long double r = std::numbers::pi_v<long double> * std::remainder(x[i], 2.0);
        ASSERT_NEAR(sine[i], static_cast<double>(std::sin(r)), 4e-16) << x[i];
        ASSERT_NEAR(cosine[i], static_cast<double>(std::cos(r)), 4e-16) << x[i];
    }
    EXPECT_EQ(sine[2], 1.0);
    EXPECT_EQ(cosine[2], 0.0);
    EXPECT_EQ(sine[4], 0.0);
    EXPECT_EQ(cosine[6], -1.0);
    const double bad = NAN;
    sine_cosine_pi(&bad, 1, sine.data(), cosine.data());
    EXPECT_TRUE(std::isnan(sine[0]) && std::isnan(cosine[0]));
}

std::vector<Point<double>> velocities(const Velocity& velocity, const Outline& at, double time) {
    std::vector<Point<double>> result(at.size());
    velocity(at, time, result);
    return result;
}

// The closed form of the path: its derivative is the velocity, and far above the surface it is a
// uniform fall.
TEST(Velocity, FallingComesToRestAtTheSurface) {
    const Falling fall{.surface = 0.3, .depth = 0.1, .speed = 2};
    const double d = 1e-6;
    for (const double height : {0.3, 0.301, 0.35, 0.5, 1.5}) {
        const Point<double> first(0.7, height);
        for (const double time : {0.0, 0.05, 0.3}) {
            const Point<double> there = fall.advected(first, time);
            const Outline at{there};
            const Point<double> velocity = velocities(fall, at, time).front();
            const Point<double> change =
                (fall.advected(first, time + d) - fall.advected(first, time - d)) / (2 * d);
            EXPECT_NEAR((velocity - change).norm(), 0, 1e-8) << height << ", " << time;
            EXPECT_GE(there.y(), 0.3 - 1e-15);
        }
        EXPECT_NEAR((fall.advected(first, 0) - first).norm(), 0, 1e-14);
    }
    EXPECT_NEAR(fall.advected({0, 1.5}, 0.3).y(), 0.9, 1e-5);
}

TEST(Velocity, SwirlIsTheDerivativeOfItsStreamFunction) {
    Random random(9);
    Outline at;
    for (int i = 0; i < 300; ++i) { // more than a block
        at.emplace_back(uniform(random, -1, 2), uniform(random, -1, 2));
    }
    const auto stream = [](double x, double y) {
        return std::pow(std::sin(pi * x) * std::sin(pi * y), 2) / pi;
    };
    const double d = 1e-5;
    const auto steady_swirl = velocities(Swirl{}, at, 3.0);
    const auto reversing = velocities(Swirl{2.0, 8.0}, at, 1.0);
    const auto stopped = velocities(Swirl{1.0, 8.0}, at, 4.0);
    Outline in_place = at;
    Swirl{}(in_place, 0.0, in_place);
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double x = at[i].x();
        const double y = at[i].y();
        EXPECT_NEAR(steady_swirl[i].x(), (stream(x, y + d) - stream(x, y - d)) / (2 * d), 2e-9);
        EXPECT_NEAR(steady_swirl[i].y(), -(stream(x + d, y) - stream(x - d, y)) / (2 * d), 2e-9);
        EXPECT_NEAR((reversing[i] - 2.0 * std::cos(pi / 8) * steady_swirl[i]).norm(), 0.0, 1e-15);
        EXPECT_LT(stopped[i].norm(), 1e-15);
        EXPECT_EQ(in_place[i], steady_swirl[i]);
    }
}

TEST(Velocity, FieldsOfTheThesis) {
    const Outline at{{4, 6}, {1, 2}, {NAN, 0}};
    const Point<double> centre{1, 2};
    EXPECT_EQ(velocities(Translation{{8, -3}}, at, 0)[1], (Point<double>{8, -3}));
    EXPECT_NEAR((velocities(Radial{centre, 10}, at, 0)[0] - Point<double>{6, 8}).norm(), 0, 1e-14);
    EXPECT_EQ(velocities(Rotation{centre, 2}, at, 0)[0], (Point<double>{-8, 6}));
    EXPECT_NEAR((velocities(Vortex{centre, 10}, at, 0)[0] - Point<double>{-8, 6}).norm(), 0, 1e-14);
    for (const Velocity& field : {Velocity(Radial{centre, 10}), Velocity(Vortex{centre, 10})}) {
        EXPECT_EQ(velocities(field, at, 0)[1], (Point<double>{0, 0})) << "in the centre";
        EXPECT_FALSE(velocities(field, at, 0)[2].allFinite()) << "not a number stays one";
    }
    EXPECT_EQ(velocities(reversed(Rotation{centre, 2}), at, 0)[0], (Point<double>{8, -6}));
}

// The exact map of the vortex of speed 1 about the origin: each circle rotates rigidly.
FlowMap vortex_map(double time) {
    return [time](std::span<Point<double>> points) {
        for (Point<double>& p : points) {
            const double c = std::cos(time / p.norm());
            const double s = std::sin(time / p.norm());
            p = Point<double>{c * p.x() - s * p.y(), s * p.x() + c * p.y()};
        }
    };
}

TEST(FlowMap, ReversalKeepsTheOrder) {
    // If a step across the reversal used the sign of the wrong leg, the order would be 1.
    const Flow flow = there_and_back(Vortex{{0, 0}, 1.0}, 2.6);
    const auto error = [&](int steps) {
        Outline half{{0.5, 0.25}};
        Outline back = half;
        Outline exact = half;
        runge_kutta_map(flow, 0.0, 2.6, steps)(half);
        runge_kutta_map(flow, 0.0, 5.2, 2 * steps)(back);
        vortex_map(2.6)(exact);
        return std::max((half[0] - exact[0]).norm(), (back[0] - Point<double>{0.5, 0.25}).norm());
    };
    EXPECT_GT(std::log2(error(16) / error(32)), 7.5);
    EXPECT_LT(error(64), 1e-12);
    EXPECT_EQ(&velocity_of_step(flow, 2.5, 2.6), &flow[0].velocity);
    EXPECT_EQ(&velocity_of_step(flow, 2.6, 2.7), &flow[1].velocity);
    EXPECT_THROW((void)velocity_of_step({}, 0, 1), InputError);
}

TEST(Exact, CircleHasTheAreaAndTheErrorItStates) {
    const ExactShape rough = exact_circle({0.5, 0.5}, 0.25, 256);
    const ExactShape fine = exact_circle({0.5, 0.5}, 0.25);
    EXPECT_NEAR(signed_area(rough.outlines) / rough.area, 1.0, 1e-15);
    EXPECT_NEAR(symmetric_difference(rough.outlines, fine.outlines) / rough.own_error, 1.0, 0.01);
    EXPECT_LT(fine.own_error / fine.area, 1e-8);
}

TEST(Exact, RigidMotions) {
    const std::vector<Outline> first{slotted_disc({}, 0.01)};
    const ExactShape round = rotated_shape(first, {0.5, 0.5}, 2.0 * pi);
    EXPECT_LT(symmetric_difference(first, round.outlines), 1e-15);
    const ExactShape half = rotated_shape(first, {0.5, 0.5}, pi);
    EXPECT_NEAR((half.outlines[0][0] + first[0][0] - Point<double>{1, 1}).norm(), 0.0, 1e-15);
    const ExactShape moved = translated_shape(first, {8, -8});
    EXPECT_EQ(moved.outlines[0][3], (Point<double>{first[0][3] + Point<double>{8, -8}}));
    EXPECT_EQ(moved.area, signed_area(first));
}

/// Every limit on a symmetric difference relies on these exact shapes, so they are computed a
/// second time by independent code: the velocity's formula written out, and far more steps.
Point<double> advected(Point<double> p, double time, double period) {
    constexpr int steps = 2000;
    const double dt = time / steps;
    const auto velocity = [&](const Point<double>& at, double t) {
        const double factor = period > 0.0 ? std::cos(pi * t / period) : 1.0;
        return Point<double>{
            factor * std::pow(std::sin(pi * at.x()), 2) * std::sin(2 * pi * at.y()),
            -factor * std::pow(std::sin(pi * at.y()), 2) * std::sin(2 * pi * at.x())};
    };
    for (int i = 0; i < steps; ++i) { // Kutta's rule of three eighths
        const double t = i * dt;
        const Point<double> k1 = velocity(p, t);
        const Point<double> k2 = velocity(p + dt / 3 * k1, t + dt / 3);
        const Point<double> k3 = velocity(p + dt * (k2 - k1 / 3), t + 2 * dt / 3);
        const Point<double> k4 = velocity(p + dt * (k1 - k2 + k3), t + dt);
        p += dt / 8 * (k1 + 3 * k2 + 3 * k3 + k4);
    }
    return p;
}

struct Swirled {
    double period; ///< 0: steady
    double time;
    double max_error; ///< of own_error
};

class FarthestOut : public testing::TestWithParam<Swirled> {};

TEST_P(FarthestOut, IsKnownToItsOwnError) {
    const auto [period, time, max_error] = GetParam();
    const ParametricCurve curve = circle_curve({0.5, 0.75}, 0.15);
    const Flow flow = steady(Swirl{1.0, period});
    const ExactShape shape = advected_shape(curve, flow, time);
    EXPECT_LT(shape.own_error, max_error);
    EXPECT_NEAR(signed_area(shape.outlines), shape.area, 1e-9);
    const MarkerOptions options;
    const ExactShape finer =
        advected_shape(curve, flow, time,
                       {.spacing = options.spacing / 1.5, .deviation = options.deviation / 2.25});
    EXPECT_LT(symmetric_difference(shape.outlines, finer.outlines), shape.own_error);
    double farthest = 0.0;
    for (int i = 0; i < 40; ++i) {
        const Point<double> p = advected(curve.point((i + 0.37) / 40), time, period);
        farthest = std::max(farthest, test::distance_from(shape.outlines.front(), p));
    }
    EXPECT_LT(farthest, 2e-8);
    EXPECT_GT(farthest, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Swirls, FarthestOut,
                         testing::Values(Swirled{2, 1, 1e-8}, Swirled{8, 4, 3e-8},
                                         Swirled{0, 2.6, 3e-8}, Swirled{0, 4.2, 1e-7}));

TEST(Exact, MarkersForAMeshMissAThousandthOfWhatItsEdgesDo) {
    const ParametricCurve curve = circle_curve({0.5, 0.75}, 0.15);
    const Flow flow = steady(Swirl{});
    const ExactShape finest = advected_shape(curve, flow, 1.3);
    double turned = 0.0;
    for (std::size_t i = 0; i < finest.outlines.front().size(); ++i) {
        const auto at = [&](std::size_t k) {
            return finest.outlines.front()[k % finest.outlines.front().size()];
        };
        turned += std::abs(turn_angle<double>(at(i), at(i + 1), at(i + 2)));
    }
    for (const double h : {0.04, 0.02, 0.01}) {
        const ExactShape shape = advected_shape(curve, flow, 1.3, markers_for(curve, h));
        const double chords = h * h * turned / 12; // of a polygon whose vertices lie on the curve
        EXPECT_LT(symmetric_difference(shape.outlines, finest.outlines), 1e-3 * chords) << h;
        EXPECT_LT(shape.own_error, 2e-3 * chords) << h;
        EXPECT_GT(shape.own_error, 1e-4 * chords) << h; // there are no more markers than needed
    }
}

TEST(Exact, TwistedSquareAgreesWithItsClosedForm) {
    const Vortex field{{0, 0}, 1.0};
    const ParametricCurve curve = polygon_curve(square(-50, -50, 100));
    const FlowMap map = vortex_map(125.0);
    const MarkerOptions options{.spacing = 4e-3, .deviation = 3e-6};
    const ExactShape closed = mapped_shape(curve, map, map, options);
    const ExactShape stepped = advected_shape(curve, steady(field), 125.0, options);
    EXPECT_LT(symmetric_difference(closed.outlines, stepped.outlines), 1e-7);
    EXPECT_NEAR(signed_area(closed.outlines), 1e4, 1e-3);
    EXPECT_GT(symmetric_difference(closed.outlines.front(), square(-50, -50, 100)), 1000.0);
}

TEST(Exact, CornersStayVertices) {
    const Outline box = square(0, 0, 100);
    // The same square with its parameter shifted, so that no corner is at parameter zero.
    const ParametricCurve plain = polygon_curve(box);
    const ParametricCurve shifted{[&](double s) {
                                      EXPECT_TRUE(s >= 0.0 && s < 1.0);
                                      return plain.point(s < 0.125 ? s + 0.875 : s - 0.125);
                                  },
                                  {0.125, 0.375, 0.625, 0.875},
                                  plain.area};
    for (const ParametricCurve& curve : {plain, shifted}) {
        const Outline outline = unmoved_shape(curve).outlines.front();
        EXPECT_LT(symmetric_difference(outline, box), 1e-10);
        EXPECT_LT(outline.size(), 10000U);
        for (const Point<double>& corner : box) {
            EXPECT_EQ(std::count(outline.begin(), outline.end(), corner), 1);
        }
    }
    const ExactShape disc = unmoved_shape(slotted_disc_curve({}));
    EXPECT_LT(symmetric_difference(disc.outlines.front(), slotted_disc({}, 2e-5)), 2e-8);
    EXPECT_EQ(disc.area, slotted_disc_area({}));
    for (const Point<double>& corner : slot_corners({})) {
        const Outline& outline = disc.outlines.front();
        EXPECT_EQ(std::count(outline.begin(), outline.end(), corner), 1);
    }
}

} // namespace

} // namespace dsc::scenes::exact_test
