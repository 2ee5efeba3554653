// SPDX-License-Identifier: MIT
// Targets at the domain boundary, of phases with a single triangle in a star, and the extent of
// small meshes.
#include "dsc/complex/gather.h"
#include "dsc/sizes/field.h"
#include "dsc/sizes/measure.h"
#include "dsc/sizes/wavefront.h"

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
