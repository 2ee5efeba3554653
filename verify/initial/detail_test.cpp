// SPDX-License-Identifier: MIT
// Detail finer than the mesh: the points that are left out, how far the interface moves, and what
// is kept.
#include "dsc/initial/initial_complex.h"
#include "dsc/queries/phases.h"
#include "shapes/shapes.h"
#include "support/curve_testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace dsc::detail_test {
namespace {

using std::numbers::pi;

constexpr double h = 0.02;

struct Thinned {
    Complex<double> complex;
    InputReport report;
};

template <class Drawn>
Thinned thinned(const std::vector<Drawn>& drawn) {
    Thinned result;
    result.complex = initial_complex<double>({}, std::span<const Drawn>(drawn), {.edge_length = h},
                                             &result.report);
    return result;
}

std::vector<Point<double>> wavy_circle(int count, double noise) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> wave(-noise, noise);
    std::vector<Point<double>> points;
    for (int i = 0; i < count; ++i) {
        const double radius = 0.2 + wave(random);
        const double angle = 2 * pi * i / count;
        points.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle));
    }
    return points;
}

// A Koch snowflake: each edge of a triangle is replaced by four, of which the inner two form a
// tooth, recursively.
std::vector<Point<double>> koch(int depth) {
    std::vector<Point<double>> points{
        {0.25, 0.35}, {0.75, 0.35}, {0.5, 0.35 + 0.5 * std::sqrt(0.75)}};
    for (int level = 0; level < depth; ++level) {
        std::vector<Point<double>> finer;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point<double> third = (points[(i + 1) % points.size()] - points[i]) / 3;
            const Point<double> out(third.y(), -third.x());
            finer.push_back(points[i]);
            finer.emplace_back(points[i] + third);
            finer.emplace_back(points[i] + 1.5 * third + std::sqrt(0.75) * out);
            finer.emplace_back(points[i] + 2 * third);
        }
        points = std::move(finer);
    }
    return points;
}

double nearest(const Point<double>& p, const std::vector<Point<double>>& outline) {
    double smallest = 1;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        smallest = std::min(smallest, distance(p, outline[i], outline[(i + 1) % outline.size()]));
    }
    return smallest;
}

TEST(InitialDetail, IsLeftOutWithinTheDeviationThatIsReported) {
    for (const auto& outline : {wavy_circle(4000, 0), wavy_circle(20000, 1e-3 * h),
                                wavy_circle(3000, 0.05 * h), koch(6)}) {
        const auto [complex, report] = thinned<Shape>({{outline, 1}});
        EXPECT_TRUE(validate(complex).ok());
        EXPECT_EQ(report.points, outline.size());
        EXPECT_GT(report.thinned, outline.size() / 2);
        EXPECT_LE(report.deviation, 0.1 * h);
        EXPECT_LE(report.area_changed, 1e-3 * h * scenes::perimeter(outline) * (1 + 1e-12));
        const double area = std::abs(scenes::signed_area(outline));
        EXPECT_NEAR(std::abs(phase_area(complex, 1) - area), report.area_changed, 1e-12);
        EXPECT_GT(test::smallest_angle(complex), 8);
        const auto curves = interface_curves(complex);
        ASSERT_EQ(curves.size(), 1U);
        std::vector<Point<double>> left;
        for (const Vertex v : curves.front().vertices) {
            left.push_back(complex.position(v));
        }
        double farthest = 0;
        for (const Point<double>& p : outline) {
            farthest = std::max(farthest, nearest(p, left));
        }
        EXPECT_LE(farthest, report.deviation * (1 + 1e-9));
        EXPECT_GT(farthest, 0.3 * report.deviation);
    }
}

// An outline with one additional point close to another one.
TEST(InitialDetail, ADoubledPointMakesNoNeedles) {
    std::vector<Point<double>> circle = scenes::circle({0.5, 0.75}, 0.15, 0.0157);
    for (const double distance : {1e-4, 1e-9, 1e-15, 0.0}) {
        for (const Point<double>& way : {Point<double>(0, 1), Point<double>(1, 0)}) {
            auto doubled = circle;
            doubled.insert(doubled.begin() + 8, Point<double>(circle[7] + distance * way));
            const auto [complex, report] = thinned<Shape>({{doubled, 1}});
            EXPECT_EQ(report.thinned, 1U);
            EXPECT_LE(report.deviation, distance);
            EXPECT_GT(test::smallest_angle(complex), 20);
        }
    }
}

// Removing either end of a short edge alone would change the area too much.
TEST(InitialDetail, BothEndsOfAShortEdgeBecomeOnePoint) {
    const auto scaled = [](std::vector<Point<double>> points) {
        for (Point<double>& p : points) {
            p = Point<double>(0.5, 0.5) + h * p;
        }
        return points;
    };
    // A thin blade, as contour plots have them.
    const auto blade = scaled({{0.075, -0.001},
                               {0.856, -0.01},
                               {1.637, -0.012},
                               {2.419, -0.009},
                               {3.166, 0},
                               {2.419, 0.076},
                               {1.637, 0.103},
                               {0.856, 0.08},
                               {0.075, 0.011},
                               {0, 0}});
    const auto [complex, report] = thinned<Shape>({{blade, 1}});
    const double area = scenes::signed_area(blade);
    EXPECT_GT(report.thinned, 0U);
    EXPECT_NEAR(phase_area(complex, 1), area, 1e-3 * area);
    EXPECT_GT(test::smallest_angle(complex), 5);
    // Another shape lies so close to the upper of the two points that the merged point must not be
    // placed there.
    const auto tips =
        scaled({{-0.6, 0}, {-0.08, -0.08}, {0.08, -0.08}, {0.6, 0}, {0.08, 0.08}, {-0.08, 0.08}});
    const auto above = scaled({{-5, 0.085}, {5, 0.085}, {5, 5}, {-5, 5}});
    const auto both = thinned<Shape>({{tips, 1}, {above, 2}});
    EXPECT_EQ(both.report.thinned, 1U);
    EXPECT_NEAR(both.report.area_changed, 0, 1e-15);
    EXPECT_NEAR(phase_area(both.complex, 1), scenes::signed_area(tips), 1e-15);
    EXPECT_TRUE(validate(both.complex).ok());
}

// The ends of curves that meet stay, and two curves between the same ends stay separate.
TEST(InitialDetail, EndsOfCurvesStay) {
    std::vector<Point<double>> arc;
    std::vector<Point<double>> other;
    for (int i = 0; i <= 2000; ++i) {
        const double angle = pi * i / 2000;
        arc.emplace_back(0.5 - 0.2 * std::cos(angle), 0.5 + 0.2 * std::sin(angle));
        other.emplace_back(0.5 - 0.2 * std::cos(angle), 0.5 - 0.05 * h * std::sin(angle));
    }
    other.front() = arc.front();
    other.back() = arc.back();
    const auto [complex, report] = thinned<Curve>({{arc, 0, 1},
                                                   {other, 1, 2},
                                                   {{arc.front(), {0, 0.5}}, 2, 0},
                                                   {{arc.back(), {1, 0.5}}, 0, 2}});
    EXPECT_TRUE(validate(complex).ok());
    EXPECT_GT(report.thinned, 3800U);
    EXPECT_NEAR(phase_area(complex, 1), pi * 0.02 + 0.1 * pi * 0.05 * h, 1e-3 * h);
}

// Sheets that are closer to each other than the allowed deviation must not cross afterwards.
TEST(InitialDetail, ThinLayersStayApart) {
    std::vector<Shape> layers;
    for (int i = 0; i < 20; ++i) {
        std::vector<Point<double>> layer;
        const double y = 0.4 + 0.05 * h * i;
        const auto at = [&](int k) { return 1e-3 * h * (k % 3); };
        for (int k = 0; k <= 3000; ++k) {
            layer.emplace_back(0.2 + 0.6 * k / 3000, y + at(k));
        }
        for (int k = 3000; k >= 0; --k) {
            layer.emplace_back(0.2 + 0.6 * k / 3000, y + 0.02 * h + at(k));
        }
        layers.push_back({layer, static_cast<Phase>(1 + i % 2)});
    }
    const auto [complex, report] = thinned(layers);
    EXPECT_TRUE(validate(complex).ok());
    EXPECT_NEAR(phase_area(complex, 1), 10 * 0.6 * 0.02 * h, report.area_changed + 1e-12);
    EXPECT_LE(report.area_changed, 20 * 1e-3 * h * 2.5);
}

// Contours of images end in films that are a fraction of their edges thick: the edges are halved
// there, and the shape stays as it is.
TEST(InitialDetail, FilmsThatEndMakeNoNeedles) {
    const auto scaled = [](std::vector<Point<double>> points) {
        for (Point<double>& p : points) {
            p = Point<double>(0.5, 0.5) + h * p;
        }
        return Shape{std::move(points), 1};
    };
    const Shape tip = scaled({{-0.316, 0.019},
                              {0.158, -0.041},
                              {0.939, -0.24},
                              {1.72, -0.559},
                              {4, -3},
                              {4, 0.1},
                              {1.72, 0.049},
                              {0.939, 0.033},
                              {0.158, 0.022}});
    const Shape sliver = scaled({{-0.561, 0.009},
                                 {-0.259, -0.031},
                                 {0.522, -0.036},
                                 {0.777, 0.009},
                                 {0.522, 0.014},
                                 {-0.259, 0.014}});
    for (const Shape& shape : {tip, sliver}) {
        const auto [complex, report] = thinned<Shape>({shape});
        EXPECT_TRUE(validate(complex).ok());
        EXPECT_EQ(report.thinned, 0U);
        EXPECT_NEAR(phase_area(complex, 1), std::abs(scenes::signed_area(shape.outline)), 1e-15);
        EXPECT_GT(test::smallest_angle(complex), 5);
    }
}

TEST(InitialDetail, ShapesBelowTheEdgeLengthAreDropped) {
    const auto square = [](double x, double side) {
        return Shape{{{x, 0.5}, {x + side, 0.5}, {x + side, 0.5 + side}, {x, 0.5 + side}}, 1};
    };
    const Shape line{{{0.1, 0.1}, {0.4, 0.1}}, 1};
    const auto [complex, report] =
        thinned<Shape>({square(0.3, 0.2), square(0.6, 0.5 * h), square(0.7, 1e-6), line});
    EXPECT_EQ(report.dropped, 3U);
    EXPECT_NEAR(report.area_dropped, 0.25 * h * h, 1e-10);
    EXPECT_NEAR(phase_area(complex, 1), 0.04, 1e-12);
    // A shape that is thin, but not small.
    const Shape thin{{{0.2, 0.5}, {0.8, 0.5}, {0.8, 0.5 + 0.1 * h}, {0.2, 0.5 + 0.1 * h}}, 1};
    EXPECT_NEAR(phase_area(thinned<Shape>({thin}).complex, 1), 0.06 * h, 1e-12);
}

} // namespace
} // namespace dsc::detail_test
