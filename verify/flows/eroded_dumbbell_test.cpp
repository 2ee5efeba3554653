// SPDX-License-Identifier: MIT
// A dumbbell that is eroded or grows, against areas and distances that are found from its outline
// alone.
#include "flows/eroded_dumbbell.h"

#include "dsc/base/error.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dsc::scenes::eroded_dumbbell_test {
namespace {

using std::numbers::pi;

const Dumbbell straight; // the neck closes at 0.03
// The roundings meet in the middle, and no part of the neck is straight.
const Dumbbell waisted{.distance = 2 * rounding_offset({.distance = 9, .rounding = 0.17}).x(),
                       .rounding = 0.17};
const Dumbbell short_neck{.centre = {2, -1}, .distance = 0.4, .neck = 0.08, .rounding = 0.06};

// The distance of a point from a closed polygon, by its edges.
double distance_from(const Outline& outline, const Point<double>& p) {
    double least = INFINITY;
    Point<double> a = outline.back();
    for (const Point<double>& b : outline) {
        const Point<double> way = b - a;
        const double along = std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (a + along * way - p).squaredNorm());
        a = b;
    }
    return std::sqrt(least);
}

bool holds(const Outline& outline, const Point<double>& p) {
    bool is_inside = false;
    Point<double> a = outline.back();
    for (const Point<double>& b : outline) {
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
            is_inside = !is_inside;
        }
        a = b;
    }
    return is_inside;
}

double signed_distance(const Outline& outline, const Point<double>& p) {
    return (holds(outline, p) ? 1 : -1) * distance_from(outline, p);
}

// The area of the points at a signed distance of more than `depth` from the outline: a quarter of
// the shape by columns, in each of which the end is found by bisection. No formula for a neck.
double area_by_distances(const Dumbbell& d, double depth) {
    constexpr int columns = 200;
    const Outline outline = dumbbell(d, 1e-3);
    const double end = d.distance / 2 + d.radius - depth;
    double sum = 0;
    for (int i = 0; i < columns; ++i) {
        // Substituted so that the columns are dense where the outline is steep.
        const double t = pi / 2 * (i + 0.5) / columns;
        const Point<double> foot = d.centre + Point<double>(end * std::sin(t), 0);
        double low = 0;
        double high = d.radius - depth;
        for (int k = 0; k < 20; ++k) {
            const double middle = (low + high) / 2;
            (signed_distance(outline, foot + Point<double>(0, middle)) > depth ? low : high) =
                middle;
        }
        sum += low * end * std::cos(t) * (pi / 2 / columns);
    }
    return 4 * sum;
}

TEST(ErodedDumbbell, HasTheAreaThatFollowsFromDistances) {
    for (const Dumbbell& d : {straight, waisted}) {
        for (const double depth : {0.0, 0.02, 0.029, 0.035, 0.06, 0.14}) {
            const double area = eroded_dumbbell(d, depth).area;
            EXPECT_NEAR(area, area_by_distances(d, depth), 3e-4 * area + 1e-6) << depth;
        }
        for (const double distance : {0.02, 0.07, 0.12}) {
            const double area = grown_dumbbell(d, distance).area;
            EXPECT_NEAR(area, area_by_distances(d, -distance), 3e-4 * area) << distance;
        }
    }
}

// Every vertex of the outline is as far from the first one as the shape has shrunk or grown.
TEST(ErodedDumbbell, HasItsBoundaryAtThatDistance) {
    for (const Dumbbell& d : {straight, waisted, short_neck}) {
        const Outline first = dumbbell(d, 5e-4);
        const auto is_at = [&](const ExactShape& shape, double depth) {
            for (const Outline& outline : shape.outlines) {
                for (std::size_t i = 0; i < outline.size(); i += 97) {
                    ASSERT_NEAR(signed_distance(first, outline[i]), depth, 1e-6) << depth;
                }
            }
        };
        for (const double depth : {0.001, 0.02, 0.03, 0.05, 0.1}) {
            is_at(eroded_dumbbell(d, depth), depth);
        }
        for (const double distance : {0.001, 0.04, 0.07, 0.15}) {
            is_at(grown_dumbbell(d, distance), -distance);
        }
    }
}

// Simpson's rule, of the length of the outlines.
double area_swept(const Dumbbell& d, double from, double to) {
    constexpr int parts = 64;
    double sum = 0;
    for (int i = 0; i <= parts; ++i) {
        const double depth = from + (to - from) * i / parts;
        const double weight = i == 0 || i == parts ? 1 : (i % 2 == 1 ? 4 : 2);
        sum += weight * perimeter(depth < 0 ? grown_dumbbell(d, -depth).outlines
                                            : eroded_dumbbell(d, depth).outlines);
    }
    return sum * (to - from) / (3 * parts);
}

// The rate at which the area changes is the length of the outline, before and after the neck closes
// or disappears.
TEST(ErodedDumbbell, LosesItsLengthTimesTheDepth) {
    const double first = dumbbell_area(straight);
    EXPECT_NEAR(eroded_dumbbell(straight, 0).area, first, 1e-15);
    EXPECT_NEAR(eroded_dumbbell(straight, 0.03 - 1e-14).area,
                first - area_swept(straight, 0, 0.03 - 1e-14), 1e-8);
    const double closed = eroded_dumbbell(straight, 0.03).area;
    EXPECT_NEAR(eroded_dumbbell(straight, 0.03 - 1e-14).area, closed, 1e-13);
    EXPECT_NEAR(eroded_dumbbell(straight, 0.035).area - eroded_dumbbell(straight, 0.1).area,
                area_swept(straight, 0.035, 0.1), 1e-8);
    EXPECT_NEAR(grown_dumbbell(straight, 0).area, first, 1e-15);
    EXPECT_NEAR(grown_dumbbell(straight, 0.05).area, first + area_swept(straight, -0.05, 0), 1e-8);
    EXPECT_NEAR(grown_dumbbell(straight, 0.1).area - grown_dumbbell(straight, 0.05).area,
                area_swept(straight, -0.1, -0.05), 1e-8);
}

TEST(ErodedDumbbell, HasOutlinesOfThatArea) {
    for (const Dumbbell& d : {straight, waisted, short_neck}) {
        for (const double depth : {0.0, 0.01, 0.0299, 0.0301, 0.05, 0.149}) {
            const ExactShape shape = eroded_dumbbell(d, depth);
            EXPECT_NEAR(signed_area(shape.outlines), shape.area, shape.own_error + 1e-15) << depth;
            EXPECT_LT(shape.own_error, 1e-7);
            EXPECT_TRUE(test::is_simple(shape.outlines));
            EXPECT_EQ(shape.outlines.size(), depth < d.neck / 2 ? 1U : 2U) << depth;
        }
        for (const double distance : {0.0, 0.01, d.rounding, 0.07, 0.2}) {
            const ExactShape shape = grown_dumbbell(d, distance);
            EXPECT_NEAR(signed_area(shape.outlines), shape.area, shape.own_error + 1e-15)
                << distance;
            EXPECT_TRUE(test::is_simple(shape.outlines));
            EXPECT_EQ(shape.outlines.size(), 1U);
        }
        EXPECT_TRUE(eroded_dumbbell(d, 0.15).outlines.empty());
        EXPECT_EQ(eroded_dumbbell(d, 0.15).area, 0);
    }
}

TEST(ErodedDumbbell, RefusesWhatIsNoShape) {
    for (const double bad : {-0.01, double{INFINITY}, double{NAN}}) {
        EXPECT_THROW((void)eroded_dumbbell({}, bad), InputError);
        EXPECT_THROW((void)grown_dumbbell({}, bad), InputError);
    }
    EXPECT_THROW((void)eroded_dumbbell({.neck = 0.3}, 0.01), InputError);
    EXPECT_THROW((void)grown_dumbbell({.rounding = 0}, 0.2), InputError);
}

TEST(Dumbbell, MayHaveAWaist) {
    EXPECT_EQ(waisted.distance / 2, rounding_offset(waisted).x());
    const Outline outline = dumbbell(waisted, 1e-4);
    EXPECT_TRUE(test::is_simple(outline));
    EXPECT_LE(test::longest_edge(outline), 1e-4 * (1 + 1e-9));
    EXPECT_NEAR(signed_area(outline), dumbbell_area(waisted), 1e-8);
    EXPECT_NEAR(distance_from(outline, waisted.centre), 0.03, 1e-8);
}

} // namespace

} // namespace dsc::scenes::eroded_dumbbell_test
