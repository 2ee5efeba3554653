// SPDX-License-Identifier: MIT
// Every pair of values of all features stands in a row, and what is known of the row's parts holds
// of the whole: exact shapes, what is conserved, other numbers of threads, runs without an
// interruption. The long program has triples, and pairs in finer meshes. A row that fails belongs
// into `found_rows`, with no more features than it needs for that.
#include "combinations/sense.h"
#include "combinations/trial.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <string>
#include <tuple>

namespace dsc::combinations::combinations_test {
namespace {

void expect_parts(const Values& values, double fineness = 1) {
    const std::string words = words_of(values);
    std::cout << words << std::endl; // the last one hangs, or has crashed
    for (const std::string& problem : try_row(row_of(values), fineness).problems) {
        ADD_FAILURE() << words << ": " << problem;
    }
}

void expect_all_parts(const Cover& cover, double fineness = 1) {
    for (const auto& row : cover.rows) {
        Values values{};
        std::copy_n(row.begin(), feature_count, values.begin());
        expect_parts(values, fineness);
    }
}

#ifdef DSC_LONG_COMBINATIONS
TEST(Combinations, OfThreeGiveWhatTheirPartsGive) { expect_all_parts(cover_features(3)); }
TEST(Combinations, GiveTheSameInFinerMeshes) { expect_all_parts(cover_features(2, 2), 2); }
#else
TEST(Combinations, OfTwoGiveWhatTheirPartsGive) { expect_all_parts(cover_features(2)); }
TEST(Combinations, ThatFailedOnceHold) {
    for (const std::string_view words : found_rows()) {
        expect_parts(values_of(words));
    }
}
#endif

// Pairs of features are left out only where it is said why.
TEST(Rows, HoldAllPairsOfValuesThatMakeSense) {
    const Cover cover = cover_features(2);
    std::set<std::tuple<std::size_t, std::size_t, int, int>> pairs;
    for (const auto& row : cover.rows) {
        for (std::size_t i = 0; i < feature_count; ++i) {
            for (std::size_t k = i + 1; k < feature_count; ++k) {
                pairs.emplace(i, k, row[i], row[k]);
            }
        }
    }
    EXPECT_EQ(pairs.size(), 3100U);
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

TEST(Rows, MakeSenseOrAreRefused) {
    EXPECT_NE(nonsense_in(values_of("place=layer motion=turn")), "");
    for (const auto found : found_rows()) {
        EXPECT_EQ(nonsense_in(values_of(found)), "") << found;
    }
    for (const std::string_view words : refused_rows()) {
        EXPECT_NE(refusal_of(row_of(values_of(words))), "") << words;
    }
}

} // namespace
} // namespace dsc::combinations::combinations_test
