// SPDX-License-Identifier: MIT
// The array itself: every combination that makes sense stands in a row, and rows are what their
// words say.
#include "combinations/covering.h"
#include "combinations/sense.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <tuple>

namespace dsc::combinations::covering_test {
namespace {

// Four features; a value of the first excludes one of the third.
Cover some_cover(std::size_t strength) {
    static constexpr std::array<std::size_t, 4> counts{3, 2, 4, 2};
    return cover({.counts = counts,
                  .strength = strength,
                  .makes_sense = [](std::span<const std::uint8_t> row, std::span<const bool> set) {
                      return !set[0] || !set[2] || row[0] != 1 || row[2] != 3;
                  }});
}

TEST(Covering, HasEveryPairThatMakesSense) {
    const Cover cover = some_cover(2);
    std::set<std::tuple<std::size_t, std::size_t, int, int>> pairs;
    for (const auto& row : cover.rows) {
        EXPECT_FALSE(row[0] == 1 && row[2] == 3);
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t k = i + 1; k < 4; ++k) {
                pairs.emplace(i, k, row[i], row[k]);
            }
        }
    }
    // 6 + 12 + 6 + 8 + 4 + 8 pairs of values, but for one.
    EXPECT_EQ(pairs.size(), 43U);
    EXPECT_EQ(cover.combinations, 43U);
    EXPECT_EQ(cover.covered, 43U);
    EXPECT_EQ(cover.senseless, 1U);
    EXPECT_LT(cover.rows.size(), 20U) << "no better than rows of any kind";
}

TEST(Covering, HasEveryTripleThatMakesSense) {
    const Cover cover = some_cover(3);
    // 24 + 12 + 24 + 16 triples, but for those of the pair that makes none.
    EXPECT_EQ(cover.covered, 76U - 4U);
    EXPECT_EQ(cover.senseless, 4U);
}

// Pairs of features are left out only where it is said why.
TEST(Rows, HoldAllPairsOfValuesThatMakeSense) {
    const Cover cover = cover_features(2);
    EXPECT_EQ(cover.covered, cover.combinations);
    EXPECT_EQ(cover.combinations, 3100U);
    EXPECT_EQ(cover.senseless, 79U);
}

TEST(Rows, AreWhatTheirWordsSay) {
    const std::string words = "place=on_wall motion=swirl way=copy precision=float";
    const Values values = values_of(words);
    EXPECT_EQ(words_of(values), words);
    const Row row = row_of(values);
    EXPECT_EQ(row.place, Place::on_wall);
    EXPECT_EQ(row.motion, Motion::swirl);
    EXPECT_EQ(row.way, Way::copy);
    EXPECT_EQ(row.precision, Precision::in_float);
    EXPECT_EQ(row.phases, Phases::one);
    for (const std::string wrong : {"speed=high", "place", "place=moon"}) {
        EXPECT_THROW((void)values_of(wrong), InputError) << wrong;
    }
}

TEST(Rows, MakeSenseOrAreSaidToMakeNone) {
    EXPECT_EQ(nonsense_in(values_of("")), "");
    EXPECT_NE(nonsense_in(values_of("place=layer motion=turn")), "");
    for (const auto found : found_rows()) {
        EXPECT_EQ(nonsense_in(values_of(found)), "") << found;
    }
}

} // namespace
} // namespace dsc::combinations::covering_test
