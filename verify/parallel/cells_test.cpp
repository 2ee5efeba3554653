// SPDX-License-Identifier: MIT
// The positions of the cuts between cells: the work is balanced, minimum widths are respected, and
// a colour is not cut where the previous one was.
#include "dsc/parallel/partition/cuts.h"

#include "support/random/scene.h"
#include "support/random/submeshes.h"

#include "dsc/complex/ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace dsc::cells_test {
namespace {

using test::Dice;
using test::Divided;
using test::random_divided;
using test::shares_of;

// The distance of a point from the sides of its region.
double depth(const Region& region, const Point<double>& p) {
    return std::min({p.x() - region.low, region.high - p.x(), p.y() - region.side_low,
                     region.side_high - p.y()});
}

double depth(const Colour& colour, const Point<double>& p) {
    return depth(colour.regions.at(colour.locate(no_id, p.x(), p.y())), p);
}

// Bounds of the smallest and the largest share, if each cut is off by at most `tolerance`.
std::pair<double, double> bounds_of(std::uint32_t cells, double tolerance) {
    if (cells == 1) {
        return {1, 1};
    }
    const std::uint32_t first = cells / 2;
    const double share = static_cast<double>(first) / cells;
    const auto one = bounds_of(first, tolerance);
    const auto other = bounds_of(cells - first, tolerance);
    return {std::min((share - tolerance) * one.first, (1 - share - tolerance) * other.first),
            std::max((share + tolerance) * one.second, (1 - share + tolerance) * other.second)};
}

TEST(Cells, ShareTheWorkWithinTheTolerance) {
    int divided_as_asked = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Dice dice(seed);
        Divided scene = random_divided(dice, false);
        const std::uint32_t cells = test::number_in(dice, 2, 6);
        CellPartitioner<double> partitioner(
            {.submeshes = cells, .min_vertices = 6, .min_width = 4});
        scene.divide(partitioner);
        const auto shares = shares_of(scene, 0);
        EXPECT_LE(shares.size(), cells);
        if (shares.size() == cells) {
            ++divided_as_asked;
            const auto [smallest, largest] = bounds_of(cells, CutRules{}.tolerance);
            for (const double share : shares) {
                EXPECT_GE(share, smallest - 1e-6) << "seed " << seed << ", cells " << cells;
                EXPECT_LE(share, largest + 1e-6) << "seed " << seed << ", cells " << cells;
            }
        }
    }
    EXPECT_GE(divided_as_asked, 20);
}

TEST(Cells, AreNoSmallerThanAllowed) {
    std::size_t cells = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Dice dice(seed);
        Divided scene = random_divided(dice, seed % 4 == 0);
        const std::uint32_t min_vertices = test::number_in(dice, 5, 30);
        const double min_width = dice.in(3.0, 12.0);
        CellPartitioner<double> partitioner(
            {.submeshes = 12, .min_vertices = min_vertices, .min_width = min_width});
        scene.divide(partitioner);
        const auto& regions = scene.regions(0);
        cells += regions.size();
        std::vector<std::uint32_t> count(regions.size(), 0);
        for (std::size_t i = 0; i < scene.interface.size(); ++i) {
            const Point<double> p = scene.position(i);
            ++count.at(scene.partition.colours[0].locate(no_id, p.x(), p.y()));
        }
        for (std::size_t i = 0; i < regions.size() && regions.size() > 1; ++i) {
            EXPECT_GE(count[i], min_vertices) << "seed " << seed << ", cell " << i;
            EXPECT_GE(regions[i].high - regions[i].low, min_width * scene.h);
            EXPECT_GE(regions[i].side_high - regions[i].side_low, min_width * scene.h);
        }
    }
    EXPECT_GT(cells, 100U);
}

// The work that the first colour deferred at its cuts lies away from the cuts of the second colour.
TEST(Cells, OfTheSecondColourAreCutWhereTheFirstHasNothingLeft) {
    for (const std::uint32_t cells : {2U, 4U, 8U}) {
        constexpr double h = 0.005;
        Divided disc(test::disc_complex<double>(h, {0.5, 0.5}, 0.3), h);
        CellPartitioner<double> partitioner({.submeshes = cells});
        disc.divide(partitioner);
        ASSERT_EQ(disc.regions(0).size(), cells);
        ASSERT_GE(disc.partition.colours.size(), 2U);
        EXPECT_GE(disc.regions(1).size(), 2U) << "the second colour runs on one thread";
        int near_first = 0;
        int near_both = 0;
        for (std::size_t i = 0; i < disc.interface.size(); ++i) {
            const Point<double> p = disc.position(i);
            if (depth(disc.partition.colours[0], p) < 3 * h) {
                ++near_first;
                near_both += depth(disc.partition.colours[1], p) < 3 * h ? 1 : 0;
            }
        }
        EXPECT_GT(near_first, 4 * static_cast<int>(cells) / 2);
        EXPECT_LE(near_both, near_first / 20) << cells << " cells, of " << near_first;
    }
}

// The default number of cells grows with the interface; small interfaces are not divided.
TEST(Cells, AreAsManyAsPay) {
    std::size_t last = 0;
    for (const double radius : {0.02, 0.1, 0.3, 0.45}) {
        constexpr double h = 0.005;
        Divided disc(test::disc_complex<double>(h, {0.5, 0.5}, radius), h);
        CellPartitioner<double> partitioner({});
        disc.divide(partitioner);
        const std::size_t cells = disc.regions(0).size();
        EXPECT_GE(cells, last);
        last = cells;
        if (radius < 0.05) {
            EXPECT_TRUE(disc.regions(0).front().is_whole());
            EXPECT_EQ(disc.partition.colours.size(), 1U);
        }
    }
    EXPECT_GE(last, 4U);
}

} // namespace
} // namespace dsc::cells_test
