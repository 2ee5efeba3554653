// SPDX-License-Identifier: MIT
// The positions of the cuts between slabs and blocks: the work is balanced, minimum widths are
// respected, and a colour is not cut where the previous one was.
#include "thesis/divisions/slabs.h"

#include "support/random/scene.h"
#include "support/random/submeshes.h"

#include "dsc/complex/ranges.h"
#include "thesis/divisions/blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace dsc::slabs_test {
namespace {

using test::Dice;
using test::Divided;
using test::shares_of;

constexpr double infinity = Region::infinity;

// Black slabs straddle the cuts of the red ones, so that no vertex is locked in both colours. If
// red cuts are left out because slabs would be too thin, the black ones are left out too.
TEST(Cuts, OfTheTwoColoursLieApart) {
    Dice dice(3);
    for (int round = 0; round < 200; ++round) {
        const double smallest = round == 0 ? 0.1 : dice.in(0.02, 0.3);
        const std::uint32_t slabs = round == 0 ? 8 : test::number_in(dice, 2, 12);
        const Cuts cuts = cuts_of_equal_width(0, 1, slabs, smallest);
        if (round == 0) {
            ASSERT_EQ(cuts.red.size(), 9U);
            ASSERT_EQ(cuts.black.size(), 10U);
        }
        for (std::size_t i = 1; i + 1 < cuts.red.size(); ++i) {
            double nearest = infinity;
            for (const double black : cuts.black) {
                nearest = std::min(nearest, std::abs(black - cuts.red[i]));
            }
            EXPECT_GE(nearest, 0.5 * smallest - 1e-12)
                << "red cut at " << cuts.red[i] << " of " << slabs << " slabs, least width "
                << smallest;
        }
    }
}

SlabOptions slab_options(Slabbing slabbing, std::uint32_t submeshes, double degrees = 0) {
    return {.slabbing = slabbing, .submeshes = submeshes, .degrees = degrees, .min_width = 3};
}

TEST(Slabs, ShareTheWork) {
    for (const double degrees : {0.0, 90.0, 33.0}) {
        Divided disc(test::disc_complex<double>(0.004, {0.5, 0.5}, 0.3), 0.004);
        for (std::size_t i = 0; i < disc.work.size(); ++i) {
            disc.work[i] = disc.position(i).y() > 0.6 ? 5.0F : 1.0F;
        }
        SlabPartitioner<double> active(slab_options(Slabbing::active, 5, degrees));
        disc.divide(active);
        ASSERT_EQ(disc.regions(0).size(), 5U);
        ASSERT_EQ(disc.regions(1).size(), 5U) << "its ends are one";
        for (const std::size_t colour : {0U, 1U}) {
            for (const double share : shares_of(disc, colour)) {
                EXPECT_NEAR(share, 0.2, 0.02) << degrees << " degrees, colour " << colour;
            }
        }
        // The counting strategy divides the number of all vertices, whatever their work.
        SlabPartitioner<double> counting(slab_options(Slabbing::counting, 5, degrees));
        disc.divide(counting);
        std::vector<int> count(5, 0);
        int total = 0;
        for (const Vertex v : vertices(disc.complex)) {
            const Point<double> p = disc.complex.position(v);
            ++count.at(disc.partition.colours[0].locate(v.id, p.x(), p.y()));
            ++total;
        }
        for (const int held : count) {
            EXPECT_NEAR(held, total / 5.0, 0.02 * total) << degrees << " degrees";
        }
    }
}

TEST(Slabs, AreCutAcrossTheDirectionAskedFor) {
    Divided disc(test::disc_complex<double>(0.01), 0.01);
    for (const double degrees : {0.0, 30.0, 90.0, 135.0, -60.0, 400.0}) {
        SlabPartitioner<double> partitioner(slab_options(Slabbing::fixed, 4, degrees));
        disc.divide(partitioner);
        ASSERT_EQ(disc.regions(0).size(), 4U);
        for (const Colour& colour : disc.partition.colours) {
            for (const Region& region : colour.regions) {
                EXPECT_NEAR(region.normal_x, std::cos(degrees * std::numbers::pi / 180), 1e-12);
                EXPECT_NEAR(region.normal_y, std::sin(degrees * std::numbers::pi / 180), 1e-12);
                EXPECT_EQ(region.side_low, -infinity);
                EXPECT_EQ(region.side_high, infinity);
            }
        }
        EXPECT_EQ(disc.regions(0).front().is_upright(), degrees == 0);
    }
}

TEST(Slabs, FollowTheShape) {
    for (const double degrees : {30.0, 0.0, 90.0, 150.0}) {
        const double turn = degrees * std::numbers::pi / 180;
        const Point<double> along(std::cos(turn), std::sin(turn));
        std::vector<Point<double>> ellipse = test::circle_points({0.5, 0.5}, 0.12, 120);
        for (Point<double>& p : ellipse) {
            p += 2 * (p - Point<double>(0.5, 0.5)).dot(along) * along;
        }
        Divided divided(
            initial_complex<double>({}, std::vector<Shape>{{ellipse, 1}}, {.edge_length = 0.01}),
            0.01);
        SlabOptions options = slab_options(Slabbing::active, 4, 77);
        options.follow_shape = true;
        SlabPartitioner<double> partitioner(options);
        divided.divide(partitioner);
        ASSERT_EQ(divided.regions(0).size(), 4U);
        for (const Region& region : divided.regions(0)) {
            const double cosine = Point<double>(region.normal_x, region.normal_y).dot(along);
            EXPECT_GT(std::abs(cosine), std::cos(3 * std::numbers::pi / 180)) << degrees;
        }
    }
}

TEST(Cuts, OfFewSlabsAreFew) {
    const std::vector<double> none{-infinity, infinity};
    std::vector<std::pair<double, float>> positions;
    for (int i = 0; i < 100; ++i) {
        positions.emplace_back(i, 1.0F);
    }
    for (const Cuts& cuts : {cuts_of_equal_share(positions, 1, 1), cuts_of_equal_width(0, 8, 1, 0),
                             cuts_of_equal_width(0, 8, 4, 100)}) {
        EXPECT_EQ(cuts.red, none);
        EXPECT_EQ(cuts.black, none);
    }
    EXPECT_EQ(cuts_of_equal_width(0, 8, 2, 0).red, (std::vector<double>{-infinity, 4, infinity}));
    const Cuts two = cuts_of_equal_share(positions, 2, 1);
    ASSERT_EQ(two.red.size(), 3U);
    EXPECT_NEAR(two.red[1], 50, 1);
    // No slab is thinner than the minimum.
    const Cuts wide = cuts_of_equal_share(positions, 8, 20);
    EXPECT_GE(wide.red.size(), 3U);
    for (const auto* list : {&wide.red, &wide.black}) {
        for (std::size_t i = 1; i + 2 < list->size(); ++i) {
            EXPECT_GE((*list)[i + 1] - (*list)[i], 20);
        }
    }
}

// --- blocks -------------------------------------------------------------------------------------

TEST(Blocks, AreSquaresShiftedByThirds) {
    constexpr double h = 0.01;
    Divided disc(test::disc_complex<double>(h, {0.5, 0.5}, 0.25), h);
    BlockPartitioner<double> partitioner({.submeshes = 17, .min_width = 8});
    disc.divide(partitioner);
    ASSERT_EQ(disc.partition.colours.size(), 3U);
    EXPECT_EQ(disc.regions(0).size(), 16U) << "the next square below";
    EXPECT_EQ(disc.regions(1).size(), 25U);
    std::array<std::set<double>, 3> cuts;
    for (std::size_t c = 0; c < 3; ++c) {
        for (const Region& region : disc.regions(c)) {
            EXPECT_TRUE(region.is_upright());
            for (const double cut : {region.low, region.high}) {
                if (std::isfinite(cut)) {
                    cuts[c].insert(cut);
                }
            }
            if (std::isfinite(region.low) && std::isfinite(region.high)) {
                EXPECT_NEAR(region.high - region.low, 0.5 / 4, h);
            }
            if (std::isfinite(region.side_low) && std::isfinite(region.side_high)) {
                EXPECT_NEAR(region.side_high - region.side_low, 0.5 / 4, h);
            }
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        for (const double one : cuts[c]) {
            for (const double other : cuts[(c + 1) % 3]) {
                EXPECT_GE(std::abs(one - other), 0.5 / 4 / 3 - h);
            }
        }
    }
    // No block is thinner than the minimum.
    BlockPartitioner<double> wide({.submeshes = 100, .min_width = 20});
    disc.divide(wide);
    EXPECT_EQ(disc.regions(0).size(), 4U);
    BlockPartitioner<double> too_wide({.submeshes = 100, .min_width = 60});
    disc.divide(too_wide);
    ASSERT_EQ(disc.partition.colours.size(), 1U);
    EXPECT_TRUE(disc.regions(0).front().is_whole());
}

} // namespace
} // namespace dsc::slabs_test
