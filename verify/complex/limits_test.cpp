// SPDX-License-Identifier: MIT
// Stars at the domain boundary and of too many triangles; numbering about the origin; sums of areas
// of very different size; what insertion refuses.
#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/numbering.h"
#include "dsc/queries/phases.h"
#include "thesis/sets/insertion_removal.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

namespace dsc::limits_test {
namespace {

TEST(RingLimits, BeyondTheEndsOfAnOpenStarLiesTheBorder) {
    const auto complex = test::grid<double>(3, 0, 1, 1.2);
    Star<double> star;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        ASSERT_TRUE(gather(complex, Region{}, v, star));
        if (!star.closed) {
            EXPECT_EQ(star.phase_before(0), border_phase);
            EXPECT_EQ(star.phase_after(star.size), border_phase);
            EXPECT_TRUE(star.is_constrained(0));
            EXPECT_TRUE(star.is_constrained(star.size));
        }
    }
}

TEST(RingLimits, AStarOfOneTriangleTooManyIsNotGathered) {
    constexpr auto largest = static_cast<std::uint32_t>(Star<double>::capacity);
    Star<double> star;
    EXPECT_TRUE(gather(test::wheel<double>(largest), Region{}, 0, star));
    EXPECT_EQ(star.size, largest);
    EXPECT_FALSE(gather(test::wheel<double>(largest + 1), Region{}, 0, star));
    EXPECT_FALSE(gather(test::wheel<double>(largest + 2), Region{}, 0, star));
}

// All coordinates are binary fractions, so both meshes have exactly the same positions within their
// bounding boxes.
TEST(NumberingLimits, TheOrderDoesNotDependOnWhereTheOriginLies) {
    const auto moved = [](double by) {
        auto complex = test::grid<double>(8);
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            const Point<double> p = complex.position(Vertex{v});
            complex.set_position(Vertex{v}, Point<double>(p.x() + by, p.y() + by));
        }
        return renumber(complex).vertices;
    };
    const auto order = moved(0);
    EXPECT_EQ(moved(-4), order);
    EXPECT_EQ(moved(-8), order);
    EXPECT_EQ(moved(16), order);
}

TEST(AreaLimits, SmallTrianglesCountBesideALargeOne) {
    Complex<double> complex;
    const auto triangle = [&](double x, double y, double side, double height) {
        const Vertex a = insert_vertex(complex, Point<double>(x, y));
        const Vertex b = insert_vertex(complex, Point<double>(x + side, y));
        const Vertex c = insert_vertex(complex, Point<double>(x, y + height));
        (void)insert_triangle(complex, a, b, c, 1);
    };
    constexpr double side = 134217728.0; // 2^27: the area is 2^54, where doubles are 4 apart
    triangle(0, 0, side, 2 * side);
    for (int i = 0; i < 16; ++i) {
        triangle(-4.0 - 4.0 * i, 0, 2, 1);
    }
    EXPECT_EQ(phase_area(complex, 1), side * side + 16);
}

} // namespace
} // namespace dsc::limits_test
