// SPDX-License-Identifier: MIT
// As few slabs as there can be, and divisions that are none.
#include "dsc/base/error.h"
#include "dsc/parallel/copied/copied_submeshes.h"
#include "dsc/parallel/partition/slabs.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace dsc::limits_test {
namespace {

TEST(CutLimits, TwoSlabsOfEqualShareHaveOneCutBetweenThem) {
    std::vector<std::pair<double, float>> positions;
    for (int i = 0; i < 100; ++i) {
        positions.emplace_back(i, 1.0F);
    }
    const Cuts two = cuts_of_equal_share(positions, 2, 1);
    ASSERT_EQ(two.red.size(), 3U);
    EXPECT_NEAR(two.red[1], 50, 1);
    const Cuts one = cuts_of_equal_share(positions, 1, 1);
    EXPECT_EQ(one.red, (std::vector<double>{-Region::infinity, Region::infinity}));
    EXPECT_EQ(one.black, one.red);
}

TEST(CutLimits, OneSlabOfAWidthHasNoCuts) {
    const std::vector<double> none{-Region::infinity, Region::infinity};
    for (const Cuts& cuts : {cuts_of_equal_width(0, 8, 1, 0), cuts_of_equal_width(0, 8, 4, 100)}) {
        EXPECT_EQ(cuts.red, none);
        EXPECT_EQ(cuts.black, none);
    }
    EXPECT_EQ(cuts_of_equal_width(0, 8, 2, 0).red,
              (std::vector<double>{-Region::infinity, 4, Region::infinity}));
}

TEST(CopyLimits, ADivisionHasSubmeshesAndADirection) {
    const auto mesh = test::grid<double>(4);
    CopiedSubmeshes<double> submeshes;
    for (const CountingDivision& bad :
         {CountingDivision{.submeshes = 0}, CountingDivision{.submeshes = 2, .normal_x = 2},
          CountingDivision{.submeshes = 2, .normal_x = 0, .normal_y = 0}}) {
        EXPECT_THROW(create_submeshes(mesh, bad, submeshes), InputError);
    }
}

} // namespace
} // namespace dsc::limits_test
