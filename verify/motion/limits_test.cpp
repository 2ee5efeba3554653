// SPDX-License-Identifier: MIT
// Fractions of a move.
#include "dsc/complex/gather.h"
#include "dsc/motion/movement.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

namespace dsc::limits_test {
namespace {

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
