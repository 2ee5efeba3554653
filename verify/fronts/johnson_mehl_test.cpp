// SPDX-License-Identifier: MIT
// Discs that grow until they fill the square, against the additively weighted Voronoi diagram. The
// limits are what is reached today; the program dsc_fronts prints all figures.
#include "fronts/johnson_mehl.h"

#include "dsc/initial/initial_complex.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

namespace dsc::fronts::johnson_mehl_test {
namespace {

using namespace scenes;

TEST(JohnsonMehl, TheWrongAreaOfDiscsThatHaveNotGrownIsWhatTheyWouldGain) {
    const GrowingDiscs discs = random_discs(2, 0);
    const Complex<double> complex = first_complex(discs, 0.01);
    const auto ring = [&](std::size_t i, double time) {
        return std::numbers::pi * time * (time + 2 * discs.radii[i]);
    };
    for (const double time : {0.005, 0.1}) { // before they meet
        const DiagramError distance = diagram_error(complex, discs, time);
        const double polygons = 1e-4; // the area that inscribed polygons lack
        EXPECT_NEAR(distance.wrong_area, ring(0, time) + ring(1, time), 2 * polygons);
        EXPECT_NEAR(distance.phase_error, ring(0, time), polygons);
    }
    EXPECT_LT(diagram_error(complex, discs, 0).wrong_area, 2e-4);
    EXPECT_EQ(diagram_error(complex, discs, 0).seam_max, 0);
}

TEST(JohnsonMehl, ASeamAcrossTheWholeSquareIsSeenAsItIs) {
    // Two equal discs beside a straight seam, and beside a seam that is slightly displaced.
    const std::vector<Curve> curves{{{{0.51, 0}, {0.51, 1}}, 1, 2}};
    const auto complex = initial_complex<double>({}, curves, {.edge_length = 0.02});
    const double time = 2;
    const GrowingDiscs even{{{0.21, 0.5}, {0.81, 0.5}}, {0.1, 0.1}, {}};
    EXPECT_LT(diagram_error(complex, even, time).wrong_area, 1e-12);
    EXPECT_LT(diagram_error(complex, even, time).seam_max, 1e-12);
    const GrowingDiscs off{{{0.20, 0.5}, {0.80, 0.5}}, {0.1, 0.1}, {}};
    EXPECT_NEAR(diagram_error(complex, off, time).wrong_area, 0.01, 1e-9);
    EXPECT_NEAR(diagram_error(complex, off, time).phase_error, 0.01, 1e-9);
    EXPECT_NEAR(diagram_error(complex, off, time).seam_rms, 0.01, 1e-3);
}

TEST(JohnsonMehl, TwoAndThreeDiscsLeaveLessWrongAreaThanTwoSquaredEdges) {
    const auto expect_less = [](const Case& one, double wrong_area) {
        const Result result = run(one);
        EXPECT_TRUE(result.is_full && result.is_valid) << one.number << ", " << one.h;
        EXPECT_LT(result.last.wrong_area, wrong_area) << one.number << ", " << one.h;
        EXPECT_GT(result.min_angle_last, 10) << one.number << ", " << one.h;
    };
    expect_less({.number = 2, .h = 0.02}, 2e-4);
    expect_less({.number = 2, .h = 0.01}, 1.8e-4);
    expect_less({.number = 3, .h = 0.02}, 5.5e-4);
    expect_less({.number = 3, .h = 0.01}, 1.4e-4);
}

// Discs as small as an edge are round all the same. In the first square and in the last two, a
// front comes to a side a sub-step before the next one does: its film must neither go too far, nor
// its end go on before the front is there. In the fourth, a strip that two fronts leave of a third
// ends at a side.
TEST(JohnsonMehl, FortySmallDiscsFillTheSquare) {
    double sum = 0;
    for (const std::uint64_t seed : {1U, 2U, 3U, 20U, 21U, 25U}) {
        const Result result = run({.number = 40, .seed = seed, .h = 0.02});
        EXPECT_TRUE(result.is_full && result.is_valid) << seed;
        EXPECT_EQ(result.unreached, 0U) << seed;
        EXPECT_GT(result.min_angle_last, 5) << seed;
        EXPECT_LT(result.last.seam_max, 0.5 * 0.02) << seed;
        sum += result.last.wrong_area;
    }
    EXPECT_LT(sum / 6, 2.2e-3);
}

// Seams at rest, to which remeshing does not come any more: beside a junction it has left a flat
// triangle in the first square, and a needle between two seams in the second.
TEST(JohnsonMehl, JunctionsOfSeamsAtRestAreMended) {
    for (const std::uint64_t seed : {1U, 5U}) {
        const Result result = run({.number = 40, .seed = seed, .h = 0.01});
        EXPECT_TRUE(result.is_full && result.is_valid) << seed;
        EXPECT_GT(result.min_angle_last, 7) << seed;
        EXPECT_LT(result.last.triple_max, 0.5 * 0.01) << seed;
        EXPECT_LT(result.last.wrong_area, 4.6e-4) << seed;
    }
}

TEST(JohnsonMehl, TenDiscsPutSeamsWithinHalfAnEdgeWithAnyThreads) {
    double sum = 0;
    std::uint64_t unreached = 0;
    for (const std::uint64_t seed : {11U, 12U, 13U, 14U, 15U, 16U}) {
        const Result result = run({.number = 10, .seed = seed, .h = 0.02});
        EXPECT_TRUE(result.is_full && result.is_valid) << seed;
        sum += result.last.wrong_area;
        unreached += result.unreached;
        EXPECT_GT(result.min_angle_last, 10) << seed;
        EXPECT_GT(result.min_angle_ever, 1) << seed;
        EXPECT_LT(result.last.seam_max, 0.5 * 0.02) << seed;
        EXPECT_LT(result.last.triple_max, 0.5 * 0.02) << seed;
    }
    EXPECT_LT(sum / 6, 5.6e-4);
    EXPECT_EQ(unreached, 0U);
    const auto hash = [](std::uint32_t threads) {
        return run({.number = 10, .seed = 11, .h = 0.02, .threads = threads}).mesh_hash;
    };
    EXPECT_EQ(hash(2), hash(3));
}

// Between two seams whose ends come to one place fast, the last edge of a front is still long when
// they are there within a sub-step.
TEST(JohnsonMehl, AFrontThatIsSqueezedOutLeavesTheTripleJunctionInItsPlace) {
    for (const std::uint64_t seed : {21U, 41U}) {
        const Result result = run({.number = 10, .seed = seed, .h = 0.01});
        EXPECT_TRUE(result.is_full && result.is_valid) << seed;
        EXPECT_EQ(result.unreached, 0U) << seed;
        EXPECT_LT(result.last.triple_max, 0.06 * 0.01) << seed;
    }
}

// In the first square a front is squeezed out before that is seen; in the second, a triangle is in
// the way of a vertex that joins the end of a seam.
TEST(JohnsonMehl, NoVertexIsLateBesideTheEndOfASeam) {
    for (const auto& [seed, h] : {std::pair{47U, 0.01}, {11U, 0.005}}) {
        const Result result = run({.number = 10, .seed = seed, .h = h});
        EXPECT_TRUE(result.is_full && result.is_valid) << seed;
        EXPECT_EQ(result.unreached, 0U) << seed;
    }
}

// A seam here runs into a side at an angle, and along it.
TEST(JohnsonMehl, ASeamEndsWhereItReachesASide) {
    const Result result = run({.number = 10, .seed = 11, .h = 0.01});
    EXPECT_TRUE(result.is_full && result.is_valid);
    EXPECT_GT(result.min_angle_last, 5);
    EXPECT_LT(result.last.wrong_area, 2e-4);
    EXPECT_LT(result.last.seam_max, 0.5 * 0.01);
}

// Ends that run along a side at a flat angle leave its edges behind them as fine as they were: flat
// triangles on coarse ones would be split again and again, down to the smallest numbers.
TEST(JohnsonMehl, AFrontThatComesToASideAtAFlatAngleLeavesItFine) {
    const Result result = run({.number = 2, .seed = 15, .h = 0.005});
    EXPECT_TRUE(result.is_full && result.is_valid);
    EXPECT_GT(result.min_angle_last, 10);
}

// The end of a front runs faster than anything else, also in the last sub-step of a step.
TEST(JohnsonMehl, EndsThatMovementLeavesFlatAreMended) {
    const Result result = run({.number = 10, .seed = 13, .h = 0.01});
    EXPECT_TRUE(result.is_full && result.is_valid);
    EXPECT_GT(result.min_angle_ever, 2);
}

} // namespace
} // namespace dsc::fronts::johnson_mehl_test
