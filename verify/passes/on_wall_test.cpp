// SPDX-License-Identifier: MIT
// What upkeep along a wall looks at before it collapses a vertex: the edge that is left, and the
// triangles.
#include "dsc/passes/wall.h"

#include "support/small_meshes.h"

#include "dsc/complex/gather.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsc::on_wall_test {
namespace {

// Vertex 0 in the middle of the wall, three triangles above it; the wall leads from 4 to 1.
class OnTheWall : public testing::Test {
protected:
    OnTheWall()
        : complex(test::build<double>({{0, 0}, {2, 0}, {1.5, 1}, {-0.2, 1}, {-1, 0}},
                                      {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}, {0, 0, 0})) {
        EXPECT_TRUE(gather(complex, Region{}, 0, ring));
        EXPECT_FALSE(ring.closed);
        EXPECT_EQ(ring.link[0], 1U);
    }

    double quality_of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const auto at = [&](std::uint32_t v) { return complex.position(Vertex{v}); };
        return quality<double>(at(a), at(b), at(c));
    }

    Complex<double> complex;
    Ring<double> ring;
};

TEST_F(OnTheWall, TheEdgeThatACollapseLeavesMayNotBeTooLong) {
    const double squared = 3 * 3;
    EXPECT_FALSE(should_collapse_on_wall<double>(ring, {0.99 * squared, 100, 0}));
    EXPECT_TRUE(should_collapse_on_wall<double>(ring, {1.01 * squared, 100, 0}));
}

TEST_F(OnTheWall, AllTrianglesCountThatACollapseLeaves) {
    const double into_first = quality_of(1, 3, 4);
    ASSERT_LT(into_first, quality_of(1, 2, 3));
    EXPECT_EQ(quality_after_wall_collapse(ring, 0), into_first);
    const double into_last = std::min(quality_of(4, 1, 2), quality_of(4, 2, 3));
    ASSERT_GT(into_last, 0);
    EXPECT_EQ(quality_after_wall_collapse(ring, ring.size), into_last);
}

} // namespace
} // namespace dsc::on_wall_test
