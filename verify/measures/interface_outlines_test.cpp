// SPDX-License-Identifier: MIT
// The outlines of a complex, read as its edges and as the cubic through its vertices.
#include "dsc/initial/initial_complex.h"
#include "dsc/passes/interface/list.h"
#include "measures/interface_outlines.h"
#include "shapes/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace dsc::scenes::interface_outlines_test {
namespace {

Complex<double> complex_of(const Outline& outline, double h) {
    const std::vector<Shape> shapes{{outline, 1}};
    auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
    mark_features(complex, collect_interface(complex), 40, 0.0);
    return complex;
}

double farthest_from_circle(const std::vector<Outline>& outlines, double radius) {
    double farthest = 0;
    for (const Outline& outline : outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point<double> middle = 0.5 * (outline[i] + outline[(i + 1) % outline.size()]);
            for (const Point<double>& p : {outline[i], middle}) {
                farthest =
                    std::max(farthest, std::abs((p - Point<double>(0.5, 0.5)).norm() - radius));
            }
        }
    }
    return farthest;
}

// With 64 chords for each edge, the chords of the cubic have 1 / 64^2 of the error of the edges.
TEST(InterfaceOutlines, OfADiscAreNearerToTheCircleByTheCubic) {
    const auto complex = complex_of(circle({0.5, 0.5}, 0.3, 0.04), 0.04);
    const auto chords = interface_outlines(complex);
    const auto cubic = interface_outlines(complex, {.reading = Reading::cubic, .samples = 64});
    ASSERT_EQ(chords.size(), 1U);
    ASSERT_EQ(cubic.size(), 1U);
    EXPECT_EQ(cubic.front().size(), 64 * chords.front().size());
    EXPECT_EQ(chords.front(), interface_outlines(complex).front());
    const double by_chords = farthest_from_circle(chords, 0.3);
    EXPECT_GT(by_chords, 1e-4);
    EXPECT_LT(farthest_from_circle(cubic, 0.3), 0.01 * by_chords);
    const double area = std::numbers::pi * 0.09;
    EXPECT_LT(std::abs(signed_area(cubic) - area), 0.01 * std::abs(signed_area(chords) - area));
}

// The cubic reading of each side is straight: it does not use vertices beyond the corners.
TEST(InterfaceOutlines, ByTheCubicHaveTheCornersOfASquare) {
    const auto complex = complex_of({{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}}, 0.05);
    const auto cubic = interface_outlines(complex, {.reading = Reading::cubic});
    ASSERT_EQ(cubic.size(), 1U);
    for (const Point<double>& p : cubic.front()) {
        EXPECT_NEAR((p - Point<double>(0.5, 0.5)).cwiseAbs().maxCoeff(), 0.2, 1e-15);
    }
    EXPECT_NEAR(signed_area(cubic), 0.16, 1e-14);
}

// A shape on the lower side of the domain, which its interface meets at various angles: the side
// stays straight.
TEST(InterfaceOutlines, ByTheCubicEndAtTheDomainBoundary) {
    for (const double height : {0.05, 0.1, 0.15, 0.2}) {
        auto complex = initial_complex<double>({}, std::vector<Shape>{}, {.edge_length = 0.1});
        for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
            Point<double> middle(0, 0);
            for (const std::uint32_t v : complex.triangles[t].v) {
                middle += complex.position(Vertex{v}) / 3;
            }
            complex.triangles[t].phase =
                (middle - Point<double>(0.5, height - 0.3)).norm() < 0.3 ? 1 : exterior_phase;
        }
        const auto chords = interface_outlines(complex);
        const auto cubic = interface_outlines(complex, {.reading = Reading::cubic, .samples = 8});
        ASSERT_EQ(chords.size(), cubic.size());
        std::size_t on_side = 0;
        for (std::size_t j = 0; j < chords.size(); ++j) {
            const Outline& edges = chords[j];
            for (std::size_t i = 0; i < edges.size(); ++i) {
                if (edges[i].y() != 0 || edges[(i + 1) % edges.size()].y() != 0) {
                    continue;
                }
                ++on_side;
                for (std::size_t k = 0; k < 8; ++k) {
                    EXPECT_EQ(cubic[j][8 * i + k].y(), 0);
                }
            }
        }
        EXPECT_GE(on_side, 2U);
    }
}

} // namespace
} // namespace dsc::scenes::interface_outlines_test
