// SPDX-License-Identifier: MIT
// Arcs whose chord is a diameter; fractions of a move.
#include "dsc/complex/gather.h"
#include "dsc/motion/interpolation.h"
#include "dsc/motion/movement.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsc::limits_test {
namespace {

// A right angle over the chord: the arc is a half circle, and its sine 1 apart from rounding.
TEST(ArcInsertion, OfAHalfCircleIsHalfAChordAway) {
    for (int i = 1; i < 2000; ++i) {
        const double turn = 0.01 * i;
        const double at = 0.1 + 0.0014 * i;
        const auto on_circle = [&](double angle) {
            return Point<double>(0.3 * std::cos(angle + turn), 0.3 * std::sin(angle + turn));
        };
        for (const double side : {1.0, -1.0}) {
            CurveNeighbours<double> n;
            n.p0 = on_circle(side * at);
            n.p1 = on_circle(0);
            n.p2 = on_circle(3.14159265358979323846);
            n.has_first = true;
            const Point<double> p = insertion_point(Insertion::arc, n);
            ASSERT_NEAR(p.norm(), 0.3, 1e-6) << i << ' ' << side;
        }
    }
}

TEST(MoveLimit, IsAShareOfTheWay) {
    const auto complex = test::hexagon<double>();
    Ring<double> ring;
    ASSERT_TRUE(gather(complex, Region{}, 0, ring));
    EXPECT_EQ(move_limit(ring, 0.01, 0.0), 1);
    EXPECT_EQ(move_limit(ring, 0.0, 0.0), 1);
    EXPECT_GT(move_limit(ring, 3.0, 0.0), 0);
    EXPECT_LT(move_limit(ring, 3.0, 0.0), 0.34);
}

} // namespace
} // namespace dsc::limits_test
