// SPDX-License-Identifier: MIT
// The Hausdorff distance against closed forms and dense sampling.
#include "dsc/base/error.h"
#include "measures/hausdorff.h"
#include "shapes/shapes.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

namespace dsc::scenes::hausdorff_test {
namespace {

using test::random_star;
using test::square;
using test::transformed;
using Random = std::mt19937_64;

double hausdorff(const Outline& p, const Outline& q) {
    return dsc::scenes::hausdorff(std::span(&p, 1), std::span(&q, 1)).distance();
}

TEST(Hausdorff, ClosedForms) {
    const Outline p = square(0, 0, 1);
    EXPECT_EQ(hausdorff(p, p), 0.0);
    EXPECT_EQ(hausdorff(p, square(0.25, 0, 1)), 0.25);
    EXPECT_NEAR(hausdorff(p, transformed(p, 1.0, {3.0, 4.0})), 5.0, 1e-15);
    const Outline inner = circle({0, 0}, 0.6, 1e-3);
    const Outline outer = circle({0, 0}, 0.7, 1.1e-3);
    EXPECT_NEAR(hausdorff(inner, outer), 0.1, 1e-6);
    // The farthest point lies inside an edge: half-way between two boxes at its ends.
    const std::vector<Outline> bar{rectangle({0, 0}, {10, 0.5}, 100.0)};
    const std::vector<Outline> ends{rectangle({-1, 0}, {0, 0.5}, 1.0),
                                    rectangle({10, 0}, {13, 0.5}, 1.0)};
    const HausdorffDistance far = dsc::scenes::hausdorff(bar, ends);
    EXPECT_NEAR(far.first_to_second, 5.0, 1e-9 * 14);
    EXPECT_NEAR(far.farthest.x(), 5.0, 1e-8);
    EXPECT_NEAR(far.second_to_first, 3.0, 1e-15);
    const double tiny = 0x1p-600;
    EXPECT_NEAR(hausdorff(transformed(inner, tiny, {0, 0}), transformed(outer, tiny, {0, 0})) /
                    tiny,
                hausdorff(inner, outer), 1e-15);
    EXPECT_EQ(dsc::scenes::hausdorff({}, bar).distance(), INFINITY);
    EXPECT_EQ(dsc::scenes::hausdorff({}, {}).distance(), 0.0);
    const std::vector<Outline> line{{{0, 0}, {1, 0}}};
    EXPECT_THROW((void)dsc::scenes::hausdorff(bar, line), InputError);
}

double sampled_distance(const Outline& from, const Outline& to, int samples) {
    // Uses plain numbers, because Eigen's vectors take ten times as long without optimisation.
    struct Edge {
        double x, y, along_x, along_y, squared;
    };
    std::vector<Edge> edges;
    for (std::size_t j = 0; j < to.size(); ++j) {
        const Point<double> d = to[(j + 1) % to.size()] - to[j];
        edges.push_back({to[j].x(), to[j].y(), d.x(), d.y(), d.squaredNorm()});
    }
    double farthest = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        for (int k = 0; k < samples; ++k) {
            const Point<double> p = from[i] + (static_cast<double>(k) / samples) *
                                                  (from[(i + 1) % from.size()] - from[i]);
            const double p_x = p.x();
            const double p_y = p.y();
            double nearest = INFINITY; // squared
            for (const Edge& e : edges) {
                const double x = p_x - e.x;
                const double y = p_y - e.y;
                double t = (x * e.along_x + y * e.along_y) / e.squared;
                t = t < 0 ? 0 : t > 1 ? 1 : t;
                const double away_x = x - t * e.along_x;
                const double away_y = y - t * e.along_y;
                const double squared = away_x * away_x + away_y * away_y;
                nearest = squared < nearest ? squared : nearest;
            }
            farthest = std::max(farthest, std::sqrt(nearest));
        }
    }
    return farthest;
}

TEST(Hausdorff, AgreesWithDenseSampling) {
    Random random(7);
    for (int i = 0; i < 40; ++i) {
        const Outline p = random_star(random, 4 + i % 40);
        const Outline q = transformed(random_star(random, 3 + i % 30), 1.2, {0.1, 0.4});
        const double there = sampled_distance(p, q, 100);
        const double back = sampled_distance(q, p, 100);
        const auto result = dsc::scenes::hausdorff(std::span(&p, 1), std::span(&q, 1));
        EXPECT_GE(result.first_to_second, there - 1e-9);
        EXPECT_GE(result.second_to_first, back - 1e-9);
        EXPECT_LE(result.first_to_second, there + 0.02);
        EXPECT_LE(result.second_to_first, back + 0.02);
    }
}

} // namespace

} // namespace dsc::scenes::hausdorff_test
