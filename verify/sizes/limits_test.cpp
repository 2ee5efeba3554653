// SPDX-License-Identifier: MIT
// Targets at the domain boundary, of phases with a single triangle in a star, and the extent of
// small meshes.
#include "dsc/complex/gather.h"
#include "dsc/sizes/rule.h"
#include "dsc/sizes/sizes.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace dsc::limits_test {
namespace {

// Only the first or the last vertex of the link has a low value.
TEST(WavefrontLimits, BothEndsOfAnOpenLinkCount) {
    const auto complex = test::grid<double>(4, 0.1);
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        Ring<double> ring;
        ASSERT_TRUE(gather(complex, Region{}, v, ring));
        if (ring.closed) {
            continue;
        }
        for (const std::uint32_t low : {0U, ring.size}) {
            LinkValues<double> values;
            values.take(ring, [&](std::uint32_t w) { return w == ring.link[low] ? 0.0 : 1e3; });
            const Point<double> end(ring.link_x(low), ring.link_y(low));
            EXPECT_NEAR(least_over_link(ring, 0.5, values),
                        0.5 * (end - Point<double>(ring.x0, ring.y0)).norm(), 1e-12)
                << v;
        }
    }
}

// Vertex 0 is reached late, from 1 alone; the front from the wall's edge between 0 and 3 arrives at
// 2 before any that goes along an edge.
TEST(WavefrontLimits, AFrontFromAWallReachesTheMeshBesideIt) {
    const std::vector<Point<double>> points{{0, 0}, {0.3, 0.02}, {-1, 1}, {-2, 0}};
    auto complex = test::build<double>(points, {{0, 1, 2}, {0, 2, 3}}, {0, 0});
    const std::vector<double> wanted{100, 1.0001, 100, 1};
    SizeOptions<double> sizes{.growth = 1.1, .longest = 100};
    sizes.by_place = [&](const Point<double>& place, double, Phase) {
        const auto at = std::ranges::find(points, place);
        return wanted[static_cast<std::size_t>(at - points.begin())];
    };
    measure_sizes(complex, sizes, 1.0, 0.0);
    const SizeField<double>& field = size_field(complex);
    const double at_0 = wanted[1] + 0.1 * points[1].norm();
    EXPECT_NEAR(field[Vertex{0}].length, at_0, 1e-12);
    const Point<double> from_0 = points[0] - points[2];
    const Point<double> from_3 = points[3] - points[2];
    const double straight =
        least_between<double>(from_3.x(), from_3.y(), 1, from_0.x(), from_0.y(), at_0, 0.1);
    ASSERT_LT(straight, 1.12);
    EXPECT_NEAR(field[Vertex{2}].length, straight, 1e-12);
}

TEST(SizeLimits, EachPhaseOfAStarIsAskedFor) {
    const std::vector<Point<double>> points{{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const std::vector<test::Indices> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
    SizeOptions<double> sizes;
    sizes.growth = 1.5;
    sizes.by_place = [](const Point<double>&, double, Phase phase) {
        return phase == 1 ? 2.0 : 4.0;
    };
    for (std::size_t single = 0; single < 4; ++single) {
        std::vector<Phase> phases(4, 0);
        phases[single] = 1;
        const auto complex = test::build<double>(points, triangles, phases);
        Ring<double> ring;
        ASSERT_TRUE(gather(complex, Region{}, 0, ring));
        EXPECT_EQ(SizeRule<double>(sizes, 1).own(ring, 0, 0), 2) << single;
    }
}

TEST(SizeLimits, TheExtentIsThatOfTheVertices) {
    const auto complex = test::build<double>({{3, 3}, {3.5, 3}, {3, 3.25}}, {{0, 1, 2}}, {0});
    EXPECT_EQ(extent_of(complex), 0.5);
}

} // namespace
} // namespace dsc::limits_test
