// SPDX-License-Identifier: MIT
// Parts of interface remeshing along the domain boundary, checked by hand.
#include "dsc/passes/boundary.h"

#include "support/small_meshes.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"
#include "dsc/passes/work.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dsc::boundary_test {
namespace {

// Four by four squares of one phase; (i, j) has the id 5 j + i.
class BoundaryParts : public testing::Test {
protected:
    Complex<double> complex = test::grid<double>(4);
    Options<double> options;
    Work<double> work{complex, options};
    Star<double> star;

    void SetUp() override { work.epoch = 1; }
    void gather_at(std::uint32_t i, std::uint32_t j) {
        ASSERT_TRUE(gather(complex, Region{}, 5 * j + i, star));
    }
};

TEST_F(BoundaryParts, IncidentEdgesAreThoseOnTheBoundary) {
    gather_at(2, 0);
    EXPECT_EQ(star.link_x(boundary_edge(star, true).link), 3); // the domain on the left
    EXPECT_EQ(star.link_x(boundary_edge(star, false).link), 1);
    EXPECT_EQ(boundary_edge(star, false).squared, 1);
    gather_at(2, 4);
    EXPECT_EQ(star.link_x(boundary_edge(star, true).link), 1);
    EXPECT_EQ(star.link_x(boundary_edge(star, false).link), 3);
}

TEST_F(BoundaryParts, LimitsAreKept) {
    gather_at(2, 0);
    EXPECT_FALSE(should_split_boundary(star, {1.01, 0.2, 0.1}));
    EXPECT_TRUE(should_split_boundary(star, {0.99, 0.2, 0.1}));
    EXPECT_FALSE(should_collapse_on_boundary(complex, star, {4.1, 0.99, 0.1}));
    EXPECT_TRUE(should_collapse_on_boundary(complex, star, {4.1, 1.01, 0.1}));
    EXPECT_TRUE(should_collapse_on_boundary(complex, star, {4.1, 0.99, 0.1}, true));
    EXPECT_FALSE(should_collapse_on_boundary(complex, star, {3.9, 1.01, 0.1}))
        << "would make a long edge";
    EXPECT_FALSE(should_collapse_on_boundary(complex, star, {3.9, 1.01, 0.1, 0.99}));
    EXPECT_TRUE(should_collapse_on_boundary(complex, star, {3.9, 1.01, 0.1, 1.01}))
        << "stops the interface";
    gather_at(2, 1);
    EXPECT_FALSE(should_split_boundary(star, {0.01, 0.001, 0.1})) << "not on the domain boundary";
    EXPECT_FALSE(should_collapse_on_boundary(complex, star, {99, 99, 0.1}))
        << "not on the domain boundary";
}

TEST_F(BoundaryParts, SplitsAtTheMiddleOfTheBoundary) {
    gather_at(2, 0);
    const SplitResult result = split_boundary(work, star);
    ASSERT_EQ(result.verdict, Verdict::legal);
    EXPECT_EQ(complex.position(result.vertex), Point<double>(2.5, 0));
    EXPECT_TRUE(is_boundary(complex, result.vertex));
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_EQ(work.active.size(), 4U);
}

TEST_F(BoundaryParts, SplitsTheEdgeOnTheOtherSideAsWell) {
    gather_at(2, 0);
    EXPECT_TRUE(should_split_boundary(star, {0.99, 0.2, 0.1}, false));
    const SplitResult result = split_boundary(work, star, false);
    ASSERT_EQ(result.verdict, Verdict::legal);
    EXPECT_EQ(complex.position(result.vertex), Point<double>(1.5, 0));
    EXPECT_EQ(validate(complex).problem, "");
}

TEST_F(BoundaryParts, CollapsesAlongTheBoundaryAndKeepsTheDomain) {
    gather_at(2, 0);
    const std::uint32_t v = star.vertex;
    ASSERT_TRUE(collapse_on_boundary(work, star, {99, 99, 0.0}));
    EXPECT_FALSE(complex.is_alive(Vertex{v}));
    EXPECT_EQ(phase_area(complex, 0), 16);
    EXPECT_EQ(validate(complex).problem, "");
    // A corner of the domain is not removed.
    gather_at(0, 0);
    EXPECT_FALSE(collapse_on_boundary(work, star, {99, 99, 0.0}));
}

TEST_F(BoundaryParts, QualityAfterACollapseIsThatOfTheTrianglesLeft) {
    gather_at(2, 0);
    const double promised = std::max(quality_after_boundary_collapse(star, 0),
                                     quality_after_boundary_collapse(star, star.size));
    Star<double> before = star;
    EXPECT_FALSE(collapse_on_boundary(work, star, {99, 99, promised * 1.001}));
    ASSERT_TRUE(collapse_on_boundary(work, star, {99, 99, promised * 0.999}));
    double worst = 1;
    for (std::uint32_t i = 0; i < before.link_size(); ++i) {
        Star<double> other;
        ASSERT_TRUE(gather(complex, Region{}, before.link[i], other));
        worst = std::min(worst, std::sqrt(worst_quality_squared(other, other.x0, other.y0)));
    }
    EXPECT_NEAR(worst, promised, 1e-12);
}

// (0.1, 0.3) to (0.4, 0.7) and similar: many midpoints are off the line because of rounding.
TEST_F(BoundaryParts, AnObliqueBoundaryIsSplitAndCollapsedLikeALevelOne) {
    for (const Vertex v : vertices(complex)) {
        const Point<double> p = complex.position(v);
        complex.set_position(v, {0.1 + 0.3 * p.x() - 0.4 * p.y(), 0.3 + 0.4 * p.x() + 0.3 * p.y()});
    }
    const std::uint32_t bound = complex.vertex_bound();
    std::vector<Vertex> off;
    for (std::uint32_t v = 0; v < bound; ++v) {
        if (!gather(complex, Region{}, v, star) || star.closed) {
            continue;
        }
        const Point<double> a(star.x0, star.y0);
        const Point<double> b(star.link_x(0), star.link_y(0));
        const SplitResult result = split_boundary(work, star);
        ASSERT_EQ(result.verdict, Verdict::legal);
        if (orientation<double>(a, complex.position(result.vertex), b) != 0) {
            off.push_back(result.vertex);
        }
    }
    EXPECT_FALSE(off.empty()) << "the test has lost its point";
    for (const Vertex v : off) {
        ASSERT_TRUE(gather(complex, Region{}, v.id, star));
        EXPECT_TRUE(collapse_on_boundary(work, star, {99, 99, 0.0}));
    }
    EXPECT_NEAR(phase_area(complex, 0), 4, 1e-14);
    EXPECT_EQ(validate(complex).problem, "");
}

// Vertex 0 in the middle of the domain boundary, three triangles above it; the domain boundary
// leads from 4 to 1.
TEST(BoundaryCollapse, AllTrianglesCountThatItLeaves) {
    const auto complex = test::build<double>({{0, 0}, {2, 0}, {1.5, 1}, {-0.2, 1}, {-1, 0}},
                                             {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, {0, 0, 0});
    Star<double> star;
    ASSERT_TRUE(gather(complex, Region{}, 0, star));
    ASSERT_EQ(star.link[0], 1U);
    const auto quality_of = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return quality<double>(complex.position(Vertex{a}), complex.position(Vertex{b}),
                               complex.position(Vertex{c}));
    };
    const double into_first = quality_of(1, 3, 4);
    ASSERT_LT(into_first, quality_of(1, 2, 3));
    EXPECT_EQ(quality_after_boundary_collapse(star, 0), into_first);
    const double into_last = std::min(quality_of(4, 1, 2), quality_of(4, 2, 3));
    ASSERT_GT(into_last, 0);
    EXPECT_EQ(quality_after_boundary_collapse(star, star.size), into_last);
}

} // namespace
} // namespace dsc::boundary_test
