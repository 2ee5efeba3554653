// SPDX-License-Identifier: MIT
// The parts of what is done to the interface along the domain boundary, checked by hand.
#include "hard/scene.h"
#include "hard/watch.h"

#include "dsc/complex/gather.h"
#include "dsc/complex/ranges.h"
#include "dsc/passes/wall.h"
#include "dsc/quality/measures.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "flows/velocity.h"

#include <gtest/gtest.h>

namespace dsc::wall_test {
namespace {

constexpr int columns = 40;
constexpr double h = 2.0 / columns;
const Rectangle domain{{0, 0}, {2, 1}};

TEST(WallMeeting, AnInterfaceThatMeetsTheWallIsNotInterpolatedAlongIt) {
    // The strip's wall is an interface as well, and turns into its side by only 35 degrees: a cubic
    // through both would bulge at the wall. The slope decides at which end of an edge this is seen.
    for (const double slope : {1.4, -1.4}) {
        const auto lean = [slope](const Point<double>& p) {
            return Point<double>(p.x() + slope * (p.y() - 0.5), p.y());
        };
        auto scene = hard::grid_scene(
            domain, columns, columns / 2,
            [slope](const Point<double>& p) {
                const double x = p.x() - slope * (p.y() - 0.5);
                return x > 0.8 && x < 1.1 ? Phase{1} : exterior_phase;
            },
            lean);
        scene.options.edge_length = h / 2; // everything is split
        hard::HardResult result;
        hard::Watch<double> watch(scene.complex, scene.options, {.domain = {{-9, 0}, {9, 1}}},
                                  result);
        watch.run(scenes::Translation{{0.01, 0}}, 0, 0.01, 3);
        hard::expect_sound(result, hard::Targets::reachable);
        EXPECT_TRUE(result.holds()) << result.failures.front();
        const scenes::Outline exact{lean({0.8003, 0}), lean({1.1003, 0}), lean({1.1003, 1}),
                                    lean({0.8003, 1})};
        EXPECT_LT(hard::shape_error(scene.complex, 1, exact), 1e-13) << slope;
    }
}

// The vertex at a place.
std::uint32_t vertex_at(const Complex<double>& complex, const Point<double>& p) {
    for (const Vertex v : vertices(complex)) {
        if (complex.position(v) == p) {
            return v.id;
        }
    }
    return no_id;
}

class WallParts : public testing::Test {
protected:
    hard::Scene<double> scene = hard::grid_scene(
        {{0, 0}, {4, 2}}, 4, 2, [](const Point<double>&) { return exterior_phase; });
    Work<double> work{scene.complex, scene.options};
    Ring<double> ring;

    void SetUp() override { work.epoch = 1; }
    void gather_at(double x, double y) {
        ASSERT_TRUE(gather(scene.complex, Region{}, vertex_at(scene.complex, {x, y}), ring));
    }
};

TEST_F(WallParts, SpokesAreThoseOnTheBoundary) {
    gather_at(2, 0);
    EXPECT_EQ(ring.link_x(wall_spoke(ring, true).link), 3); // the domain on the left
    EXPECT_EQ(ring.link_x(wall_spoke(ring, false).link), 1);
    EXPECT_EQ(wall_spoke(ring, false).squared, 1);
    gather_at(2, 2);
    EXPECT_EQ(ring.link_x(wall_spoke(ring, true).link), 1);
    EXPECT_EQ(ring.link_x(wall_spoke(ring, false).link), 3);
}

TEST_F(WallParts, LimitsAreKept) {
    gather_at(2, 0);
    EXPECT_FALSE(should_split_wall(ring, {1.01, 0.2, 0.1}));
    EXPECT_TRUE(should_split_wall(ring, {0.99, 0.2, 0.1}));
    EXPECT_FALSE(should_collapse_on_wall(ring, {4.1, 0.99, 0.1}));
    EXPECT_TRUE(should_collapse_on_wall(ring, {4.1, 1.01, 0.1}));
    EXPECT_TRUE(should_collapse_on_wall(ring, {4.1, 0.99, 0.1}, true));
    EXPECT_FALSE(should_collapse_on_wall(ring, {3.9, 1.01, 0.1})) << "would make a long edge";
    EXPECT_FALSE(should_collapse_on_wall(ring, {3.9, 1.01, 0.1, 0.99}));
    EXPECT_TRUE(should_collapse_on_wall(ring, {3.9, 1.01, 0.1, 1.01})) << "stops the interface";
    gather_at(2, 1);
    EXPECT_FALSE(should_split_wall(ring, {0.01, 0.001, 0.1})) << "not on the wall";
    EXPECT_FALSE(should_collapse_on_wall(ring, {99, 99, 0.1})) << "not on the wall";
}

TEST_F(WallParts, SplitsAtTheMiddleOfTheWall) {
    gather_at(2, 0);
    const SplitResult result = split_wall(work, ring);
    ASSERT_EQ(result.verdict, Verdict::legal);
    EXPECT_EQ(scene.complex.position(result.vertex), Point<double>(2.5, 0));
    EXPECT_TRUE(is_boundary(scene.complex, result.vertex));
    EXPECT_EQ(validate(scene.complex).problem, "");
    EXPECT_EQ(work.active.size(), 4U);
}

TEST_F(WallParts, SplitsTheEdgeOnTheOtherSideAsWell) {
    gather_at(2, 0);
    EXPECT_TRUE(should_split_wall(ring, {0.99, 0.2, 0.1}, false));
    const SplitResult result = split_wall(work, ring, false);
    ASSERT_EQ(result.verdict, Verdict::legal);
    EXPECT_EQ(scene.complex.position(result.vertex), Point<double>(1.5, 0));
    EXPECT_EQ(validate(scene.complex).problem, "");
}

TEST_F(WallParts, CollapsesAlongTheWallAndKeepsTheDomain) {
    gather_at(2, 0);
    const std::uint32_t v = ring.vertex;
    ASSERT_TRUE(collapse_on_wall(work, ring, {99, 99, 0.0}));
    EXPECT_FALSE(scene.complex.is_alive(Vertex{v}));
    EXPECT_EQ(hard::domain_area(scene.complex), 8);
    EXPECT_EQ(validate(scene.complex).problem, "");
    // One quality afterwards, the promised one; a corner is not removed.
    gather_at(0, 0);
    EXPECT_FALSE(collapse_on_wall(work, ring, {99, 99, 0.0}));
}

TEST_F(WallParts, QualityAfterACollapseIsThatOfTheTrianglesLeft) {
    gather_at(2, 0);
    const double promised = std::max(quality_after_wall_collapse(ring, 0),
                                     quality_after_wall_collapse(ring, ring.size));
    Ring<double> before = ring;
    EXPECT_FALSE(collapse_on_wall(work, ring, {99, 99, promised * 1.001}));
    ASSERT_TRUE(collapse_on_wall(work, ring, {99, 99, promised * 0.999}));
    double worst = 1;
    for (std::uint32_t i = 0; i < before.link_size(); ++i) {
        Ring<double> star;
        ASSERT_TRUE(gather(scene.complex, Region{}, before.link[i], star));
        worst = std::min(worst, std::sqrt(worst_quality_squared(star, star.x0, star.y0)));
    }
    EXPECT_NEAR(worst, promised, 1e-12);
}

TEST_F(WallParts, AnObliqueMiddleThatRoundsOffTheWallIsNotTaken) {
    // (0.1, 0.3) to (0.4, 0.7) and similar: some midpoints are off the line because of rounding.
    auto turned = hard::grid_scene(
        {{0, 0}, {4, 2}}, 4, 2, [](const Point<double>&) { return exterior_phase; },
        [](const Point<double>& p) {
            return Point<double>(0.1 + 0.3 * p.x() - 0.4 * p.y(), 0.3 + 0.4 * p.x() + 0.3 * p.y());
        });
    Work<double> other(turned.complex, turned.options);
    other.epoch = 1;
    const std::uint32_t bound = turned.complex.vertex_bound();
    int off = 0;
    for (std::uint32_t v = 0; v < bound; ++v) {
        if (!gather(turned.complex, Region{}, v, ring) || ring.closed) {
            continue;
        }
        const Point<double> a(ring.x0, ring.y0);
        const Point<double> b(ring.link_x(0), ring.link_y(0));
        const bool is_on = orientation<double>(a, midpoint<double>(a, b), b) == 0;
        off += is_on ? 0 : 1;
        EXPECT_EQ(split_wall(other, ring).verdict, is_on ? Verdict::legal : Verdict::on_boundary);
    }
    EXPECT_GT(off, 0) << "the test has lost its point";
}

} // namespace
} // namespace dsc::wall_test
