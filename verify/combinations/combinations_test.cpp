// SPDX-License-Identifier: MIT
// Every pair of feature values occurs in two rows. Each row's run is compared with what follows
// from its features: exact shapes, conserved quantities, and equal results with other numbers of
// threads, in other units, resumed, replayed, and without an interruption. The long program has all
// triples, and all pairs in finer meshes. A row that fails belongs in found.txt, reduced to the
// features that the failure needs.
#include "combinations/rows.h"
#include "combinations/trial.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <span>
#include <string>
#include <utility>

namespace dsc::combinations::combinations_test {
namespace {

// Resets features to their defaults, one by one, while the row still fails.
Values cut_down(Values values, double fineness) {
    for (bool is_smaller = true; is_smaller;) {
        is_smaller = false;
        for (std::size_t i = 0; i < values.size(); ++i) {
            Values plainer = values;
            plainer[i] = 0;
            if (values[i] != 0 && nonsense_in(row_of(plainer)).empty() &&
                !problems_of(row_of(plainer), fineness).empty()) {
                values = plainer;
                is_smaller = true;
            }
        }
    }
    return values;
}

void expect_parts(std::span<const Values> rows, double fineness = 1) {
    const std::vector<Values> open = open_rows();
    bool is_first = true;
    for (const Values& values : rows) {
        if (std::ranges::find(open, values) != open.end()) {
            continue;
        }
        const std::string words = words_of(values);
        std::cout << words << std::endl; // if a row hangs or crashes, it is the last one printed
        for (const std::string& problem : problems_of(row_of(values), fineness)) {
            ADD_FAILURE() << words << ": " << problem;
            if (std::exchange(is_first, false)) {
                std::cout << "cut down: " << words_of(cut_down(values, fineness)) << std::endl;
            }
        }
    }
}

#ifdef DSC_LONG_COMBINATIONS
TEST(Combinations, OfThreeGiveWhatTheirPartsGive) { expect_parts(cover_features(3).rows); }
TEST(Combinations, GiveTheSameInFinerMeshes) { expect_parts(cover_features(2, 2).rows, 2); }
TEST(Combinations, ThatAreOpenStillFail) {
    for (const Values& values : open_rows()) {
        EXPECT_FALSE(problems_of(row_of(values)).empty())
            << words_of(values) << " holds: it belongs into found.txt";
    }
}
#else
TEST(Combinations, OfTwoGiveWhatTheirPartsGive) { expect_parts(cover_features(2).rows); }
TEST(Combinations, OfTwoInOtherRowsDoSoToo) { expect_parts(cover_features(2, 2).rows); }
TEST(Combinations, ThatFailedOnceHold) { expect_parts(found_rows()); }
#endif

// Every pair of values occurs, unless `nonsense_in` gives the reason why it cannot.
TEST(Rows, HoldAllPairsOfValuesThatMakeSense) {
    const Cover cover = cover_features(2);
    EXPECT_EQ(cover.combinations, 2287U);
    EXPECT_EQ(cover.senseless, 39U);
    EXPECT_LE(cover.rows.size(), 100U);
}

TEST(Rows, AreWhatTheirWordsSay) {
    const std::string words =
        "place=on_boundary motion=swirl way=copy precision=in_float inside=advected";
    const Values values = values_of(words);
    EXPECT_EQ(words_of(values), words);
    EXPECT_EQ(row_of(values).motion, Motion::swirl);
    EXPECT_EQ(row_of(values).inside, Inside::advected);
    for (const std::string wrong : {"speed=high", "place", "place=moon"}) {
        EXPECT_THROW((void)values_of(wrong), InputError) << wrong;
    }
}

TEST(Rows, ThatFailedOnceMakeSense) {
    EXPECT_NE(nonsense_in(row_of(values_of("place=layer motion=turn"))), "");
    for (const Values& found : found_rows()) {
        EXPECT_EQ(nonsense_in(row_of(found)), "") << words_of(found);
    }
}

} // namespace
} // namespace dsc::combinations::combinations_test
