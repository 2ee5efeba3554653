// SPDX-License-Identifier: MIT
// Angles at junctions on hand-made meshes.
#include "measures/junctions.h"
#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::test::junctions_test {
namespace {

using namespace dsc::scenes;

constexpr double degree = std::numbers::pi / 180;

// n curves of two edges each from vertex 0, with these directions and curvatures (positive to the
// left), and a phase between neighbouring curves. Edges have the length h; vertices 2 i + 1 and 2 i
// + 2 are on curve i.
Complex<double> star_of(const std::vector<double>& directions_deg,
                        const std::vector<double>& curvatures, double h,
                        const std::vector<Phase>& phases) {
    std::vector<Point<double>> points{{0, 0}};
    const auto n = static_cast<std::uint32_t>(directions_deg.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        Point<double> at(0, 0);
        for (int k = 0; k < 2; ++k) {
            // The direction of the chord from arc length k h to (k + 1) h is that of the tangent at
            // its middle.
            const double angle = directions_deg[i] * degree + curvatures[i] * h * (k + 0.5);
            at += h * Point<double>(std::cos(angle), std::sin(angle));
            points.push_back(at);
        }
    }
    std::vector<Indices> list;
    std::vector<Phase> of;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = 2 * i + 1;
        const std::uint32_t b = 2 * ((i + 1) % n) + 1;
        for (const Indices& t :
             {Indices{0, a, b}, Indices{a, a + 1, b}, Indices{b, a + 1, b + 1}}) {
            list.push_back(t);
            of.push_back(phases[i]);
        }
    }
    return build<double>(points, list, of);
}

TEST(Junctions, AreWhereThreePhasesMeet) {
    const auto K = star_of({0, 100, 230}, {0, 0, 0}, 1, {1, 2, 0});
    const auto junctions = measure_junctions(K);
    ASSERT_EQ(junctions.size(), 1U);
    EXPECT_EQ(junctions[0].vertex, Vertex{0});
    EXPECT_EQ(junctions[0].sectors, 3U);
    EXPECT_NEAR(junctions[0].min_deg, 100, 1e-12);
    EXPECT_NEAR(junctions[0].max_deg, 130, 1e-12);
    const JunctionFigures figures = summarise(junctions);
    EXPECT_EQ(figures.count, 1U);
    EXPECT_EQ(figures.crossings, 0U);
    EXPECT_NEAR(figures.worst_deviation_deg, 20, 1e-12);
}

TEST(Junctions, AlsoWhereAPhaseTouchesItself) {
    const auto junctions =
        measure_junctions(star_of({0, 80, 180, 260}, {0, 0, 0, 0}, 1, {1, 0, 1, 0}));
    ASSERT_EQ(junctions.size(), 1U);
    EXPECT_EQ(junctions[0].sectors, 4U);
    EXPECT_NEAR(junctions[0].min_deg, 80, 1e-12);
    EXPECT_NEAR(junctions[0].max_deg, 100, 1e-12);
    const JunctionFigures figures = summarise(junctions);
    EXPECT_EQ(figures.crossings, 1U);
    EXPECT_TRUE(std::isnan(figures.worst_deviation_deg));
}

// A vertex of a curve between two phases is no junction, nor is an end of a curve on the domain
// boundary.
TEST(Junctions, AreNowhereElse) {
    EXPECT_TRUE(measure_junctions(grid<float>(8, 0.1, 1, 3)).empty());
    const auto figures = summarise(std::vector<Junction>{});
    EXPECT_EQ(figures.count, 0U);
    EXPECT_TRUE(std::isnan(figures.worst_deviation_deg));
    // Three interface edges meet at the middle of a side of the domain.
    const std::vector<Point<double>> points{{0, 0}, {2, 0}, {1, 1}, {0, 2}, {-1, 1}, {-2, 0}};
    const auto K =
        build<double>(points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, {1, 2, 3, 4});
    EXPECT_TRUE(measure_junctions(K).empty());
}

// One curve bends: the error of the angles is (h / R)^3 / 4; that of the chords would be h / 2R.
TEST(Junctions, AnglesAreReadFromTheCurves) {
    const double h = 0.1;
    const double error = std::pow(h, 3) / 4 / degree;
    for (const double curvature : {1.0, -1.0}) {
        const auto junctions =
            measure_junctions(star_of({0, 120, 240}, {curvature, 0, 0}, h, {1, 2, 3}));
        ASSERT_EQ(junctions.size(), 1U);
        EXPECT_NEAR(junctions[0].min_deg, 120, 1.01 * error);
        EXPECT_NEAR(junctions[0].max_deg, 120, 1.01 * error);
        EXPECT_GT(junctions[0].max_deg, 120 + 0.9 * error) << "the error is known";
    }
}

TEST(Junctions, TheWorst) {
    const JunctionFigures figures =
        summarise({{Vertex{0}, 3, 119, 121}, {Vertex{1}, 3, 117, 130}, {Vertex{2}, 4, 60, 120}});
    EXPECT_EQ(figures.count, 3U);
    EXPECT_EQ(figures.crossings, 1U);
    EXPECT_EQ(figures.worst_deviation_deg, 10);
}

} // namespace
} // namespace dsc::test::junctions_test
