// SPDX-License-Identifier: MIT
// Two discs that grow, merge and shrink, against an area computed from distances alone.
#include "flows/two_discs.h"

#include "measures/symmetric_difference.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::scenes::two_discs_test {
namespace {

using std::numbers::pi;

TEST(TwoDiscs, HaveOutlinesOfThatArea) {
    // Two discs at an arbitrary position and direction.
    const TwoDiscs discs{.first = {0.3, 0.2}, .second = {0.45, 0.4}, .radius = 0.1};
    for (const double growth : {-0.02, 0.0, 0.02, 0.0249, 0.0251, 0.1}) {
        for (const double shrinkage : {0.0, 0.01, 0.07, 0.1, 0.155, 0.157, 0.19}) {
            const ExactShape shape = shrunk_discs(discs, growth, shrinkage);
            EXPECT_NEAR(signed_area(shape.outlines), shape.area, shape.own_error + 1e-15)
                << growth << ", " << shrinkage;
            EXPECT_LT(shape.own_error, 1e-7);
            EXPECT_TRUE(test::is_simple(shape.outlines));
        }
    }
}

TEST(TwoDiscs, MergeAndPart) {
    const TwoDiscs discs; // they touch at a growth of 0.025
    EXPECT_EQ(shrunk_discs(discs, 0.0249, 0).outlines.size(), 2U);
    EXPECT_EQ(shrunk_discs(discs, 0.0251, 0).outlines.size(), 1U);
    const double parting = std::sqrt(0.2 * 0.2 - 0.125 * 0.125);
    EXPECT_NEAR(parting, 0.15612, 1e-5);
    EXPECT_EQ(shrunk_discs(discs, 0.1, parting - 1e-4).outlines.size(), 1U);
    EXPECT_EQ(shrunk_discs(discs, 0.1, parting + 1e-4).outlines.size(), 2U);
    EXPECT_TRUE(shrunk_discs(discs, 0.1, 0.2).outlines.empty());
    EXPECT_EQ(shrunk_discs(discs, 0.1, 0.2).area, 0);
    // Growth followed by shrinkage adds only the area between the merged discs.
    const double before = shrunk_discs(discs, 0, 0).area;
    EXPECT_NEAR(shrunk_discs(discs, 0.02, 0.02).area, before, 1e-15);
    EXPECT_GT(shrunk_discs(discs, 0.1, 0.1).area, before + 1e-3);
}

} // namespace

} // namespace dsc::scenes::two_discs_test
