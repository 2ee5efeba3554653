// SPDX-License-Identifier: MIT
// Where the submeshes of all colours are cut.
#include "dsc3/parallel/division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace dsc3::test::division_test {
namespace {

// On a sphere, evenly.
std::vector<Point> sphere(double radius, std::size_t count) {
    std::vector<Point> places;
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1 - (2.0 * double(i) + 1) / double(count);
        const double turn = 2.399963229728653 * double(i);
        const double r = std::sqrt(1 - z * z);
        places.push_back(radius * Point(r * std::cos(turn), r * std::sin(turn), z));
    }
    return places;
}

TEST(Division3, SharesAreNearlyEqual) {
    const std::vector<Point> places = sphere(30, 6000);
    std::vector<Point> given = places;
    const auto trees = cut_colours(given, 8, 1);
    std::array<std::size_t, 8> shares{};
    for (const Point& p : places) {
        ++shares[trees[0].cell(p)];
    }
    const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
    EXPECT_GT(*least, 0.6 * 6000 / 8);
    EXPECT_LT(*most, 1.5 * 6000 / 8);
}

// What the footprint of an edit near a cut prevents in one colour, another one does.
TEST(Division3, EachPlaceIsFarFromTheCutsOfSomeColour) {
    for (const double radius : {20.0, 40.0, 80.0}) {
        const std::vector<Point> places = sphere(radius, 6000);
        std::vector<Point> given = places;
        const auto trees = cut_colours(given, 0, 1);
        const auto near_all = std::count_if(places.begin(), places.end(), [&](const Point& p) {
            return std::all_of(trees.begin(), trees.end(),
                               [&](const CutTree& tree) { return tree.distance(p) < 3.5; });
        });
        EXPECT_LT(near_all, 0.03 * 6000) << "radius " << radius;
    }
}

TEST(Division3, SmallCellsAreNotCutAgain) {
    const std::vector<Point> places = sphere(7, 1000); // 14 edge lengths wide
    std::vector<Point> given = places;
    const auto trees = cut_colours(given, 8, 1);
    std::set<std::uint32_t> cells;
    for (const Point& p : places) {
        cells.insert(trees[0].cell(p));
    }
    EXPECT_EQ(cells.size(), 2U);
    std::vector<Point> none;
    EXPECT_EQ(cut_colours(none, 4, 1)[3].cell(Point(1, 2, 3)), 0U);
}

TEST(Division3, ATetBelongsToASubmeshIfAllOfItsVerticesDo) {
    const Label a = 0x03020100;
    EXPECT_EQ(outer_of(a, a, a, a), 0U);
    EXPECT_EQ(outer_of(a, a, a | 0x80, a), 0U); // the outer bit itself makes no difference
    EXPECT_EQ(outer_of(a, a, a ^ 0x01, a), 0x80U);
    EXPECT_EQ(outer_of(a, a ^ 0x02000000, a, a ^ 0x0100), 0x80008000U);
    Ownership ownership;
    ownership.labels = {a, a, a, a ^ 0x0100, a};
    ownership.note({{0, 1, 2, 3}, {}});
    EXPECT_EQ(ownership.owner(std::array{0U, 1U, 2U, 3U}, 0), 0U);
    EXPECT_EQ(ownership.owner(std::array{0U, 1U, 2U, 3U}, 1), no_id);
    EXPECT_EQ(ownership.owner(std::array{0U, 1U, 2U}, 1), no_id); // each has a star with that tet
    EXPECT_EQ(ownership.owner(std::array{4U}, 1), 1U);
    EXPECT_EQ(ownership.owner(std::array{0U, 4U}, 3), 3U);
}

} // namespace
} // namespace dsc3::test::division_test
