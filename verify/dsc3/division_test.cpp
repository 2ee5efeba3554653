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
    const auto trees = cut_colours(given, {.submeshes = 8}, 1);
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
        const auto trees = cut_colours(given, {}, 1);
        const auto near_all = std::count_if(places.begin(), places.end(), [&](const Point& p) {
            return std::all_of(trees.begin(), trees.end(),
                               [&](const CutTree& tree) { return tree.distance(p) < 3.5; });
        });
        EXPECT_LT(near_all, 0.03 * 6000) << "radius " << radius;
    }
}

TEST(Division3, SlabsAndBlocks) {
    std::vector<Point> places = sphere(30, 6000);
    for (Point& p : places) {
        p = {p.x(), 3 * p.y() + (p.y() > 0 ? p.y() : 0), 2 * p.z()}; // longest in y, then in z
    }
    const auto divided = [&](Division division, std::uint32_t submeshes) {
        std::vector<Point> given = places;
        const CutTree tree =
            cut_colours(given, {.submeshes = submeshes, .division = division}, 1)[0];
        struct Part {
            std::size_t count = 0;
            Point low = Point::Constant(1e9);
            Point high = Point::Constant(-1e9);
        };
        std::vector<Part> parts(submeshes);
        for (const Point& p : places) {
            Part& part = parts[tree.cell(p)];
            ++part.count;
            part.low = part.low.cwiseMin(p);
            part.high = part.high.cwiseMax(p);
        }
        return parts;
    };
    for (const auto& part : divided(Division::fixed, 8)) {
        EXPECT_NEAR(part.high.y() - part.low.y(), 210.0 / 8, 1);
    }
    double end = -91;
    for (const auto& part : divided(Division::active, 8)) {
        EXPECT_NEAR(double(part.count), 6000.0 / 8, 60);
        EXPECT_GT(part.low.y(), end);
        end = part.high.y();
    }
    const auto blocks = divided(Division::blocks, 4);
    for (const auto& part : blocks) {
        EXPECT_NEAR(double(part.count), 6000.0 / 4, 60);
    }
    EXPECT_LE(blocks[1].high.y(), blocks[2].low.y());
    EXPECT_LE(blocks[0].high.z(), blocks[1].low.z());
    EXPECT_LE(blocks[2].high.z(), blocks[3].low.z());
}

// The later colours do what an application's own partition prevents.
TEST(Division3, PlacesNearTheBordersOfAPartitionAreFarFromLaterCuts) {
    const std::vector<Point> places = sphere(40, 6000);
    std::vector<Point> given = places;
    const auto sector = [](const Point& p) {
        return static_cast<std::uint32_t>(std::floor(std::atan2(p.y(), p.x()) + 4));
    };
    const auto trees = cut_colours(given, {.submeshes = 8, .partition = sector}, 1);
    std::size_t near_border = 0;
    std::size_t near_all = 0;
    for (const Point& p : places) {
        const bool is_near = std::any_of(places.begin(), places.end(), [&](const Point& q) {
            return (p - q).norm() < 3.5 && sector(p) != sector(q);
        });
        near_border += is_near ? 1U : 0U;
        near_all +=
            is_near && std::all_of(trees.begin() + 1, trees.end(),
                                   [&](const CutTree& tree) { return tree.distance(p) < 3.5; })
                ? 1U
                : 0U;
    }
    EXPECT_GT(near_border, 600U);
    EXPECT_LT(near_all, 0.05 * double(near_border));
    Ownership ownership{.trees = trees, .partition = sector, .submeshes = 4, .labels = {}};
    for (const Point& p : {Point(1, 2, 3), Point(-1, -2, 3)}) {
        EXPECT_EQ(byte_of(ownership.label_at(p), 0), sector(p) % 4);
        EXPECT_EQ(byte_of(ownership.label_at(p), 2), trees[2].cell(p));
    }
}

TEST(Division3, SmallCellsAreNotCutAgain) {
    const std::vector<Point> places = sphere(7, 1000); // 14 edge lengths wide
    std::vector<Point> given = places;
    const auto trees = cut_colours(given, {.submeshes = 8}, 1);
    std::set<std::uint32_t> cells;
    for (const Point& p : places) {
        cells.insert(trees[0].cell(p));
    }
    EXPECT_EQ(cells.size(), 2U);
    std::vector<Point> none;
    EXPECT_EQ(cut_colours(none, {.submeshes = 4}, 1)[3].cell(Point(1, 2, 3)), 0U);
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
