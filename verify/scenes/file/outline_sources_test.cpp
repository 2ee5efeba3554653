// SPDX-License-Identifier: MIT
// Lines from files of points.
#include "scenes/file/outlines/pieces.h"

#include "dsc/base/error.h"
#include "shapes/outline.h"

#include <gtest/gtest.h>

namespace dsc::scenes::outline_sources_test {
namespace {

TEST(Pieces, AreHolesInsideAnOddNumberOfOthers) {
    const auto pieces = read_points("0 0\n9 0\n9 9\n0 9\n\n1 1\n8 1\n8 8\n1 8\n\n"
                                    "2 2\n7 2\n7 7\n2 7\n\n20 0\n29 0\n29 9\n20 9\n",
                                    true, "file");
    EXPECT_EQ(nesting(pieces), (std::vector<int>{0, 1, 0, 0}));
}

TEST(Points, AreReadInPieces) {
    const auto pieces = read_points(
        "# a triangle\n0 0\n1,0\n 0.5\t1 # top\n\n\n3 3\r\n4 3\r\n4 4\r\n3 3\r\n", false, "file");
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].points, (Outline{{0, 0}, {1, 0}, {0.5, 1}}));
    EXPECT_FALSE(pieces[0].is_closed);
    EXPECT_EQ(pieces[1].points.size(), 3U);
    EXPECT_TRUE(pieces[1].is_closed) << "it comes back";
    EXPECT_TRUE(read_points("0 0\n1 0\n1 1", true, "file")[0].is_closed);
    const auto flat = read_points("0 0 7\n1 0 7\n1 1 7.0\n\n2,0,3\n3,0,3\n3,1,3\n", true, "file");
    ASSERT_EQ(flat.size(), 2U);
    EXPECT_EQ(flat[1].points, (Outline{{2, 0}, {3, 0}, {3, 1}})) << "one height each";
    EXPECT_THROW((void)read_points("# nothing\n", true, "file"), InputError);
    for (const char* bad :
         {"0 0\n1", "0 0\n1 x", "0 0 1\n1 2 3", "0 0\n1 2 3 4", "0 0\nnan 0", "0 0\n1e300 0"}) {
        try {
            (void)read_points(bad, true, "file");
            ADD_FAILURE() << bad;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), "file:2") << "the line";
        }
    }
}

} // namespace
} // namespace dsc::scenes::outline_sources_test
