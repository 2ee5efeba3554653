// SPDX-License-Identifier: MIT
// Where each partitioner cuts: the work is shared, widths are respected, and a colour is not cut
// where the one before it was.
#include "dsc/parallel/partition/partition.h"

#include "support/random_scene.h"
#include "support/random_submeshes.h"

#include "dsc/complex/ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace dsc {
namespace {

using test::Dice;
using test::Divided;
using test::random_divided;

constexpr double infinity = Region::infinity;

// --- slabs --------------------------------------------------------------------------------------

using Positions = std::vector<std::pair<double, float>>;

TEST(Cuts, GiveEachSlabTheSameShareAndNoneIsThin) {
    Dice dice(1);
    for (const bool weighted : {false, true}) {
        Positions positions;
        double total = 0;
        for (int i = 0; i < 4000; ++i) {
            const double place = dice.chance(0.5) ? dice.in(0.0, 1.0) : dice.in(0.2, 0.5);
            positions.emplace_back(place, weighted ? static_cast<float>(dice.in(1.0, 9.0)) : 1.0F);
            total += static_cast<double>(positions.back().second);
        }
        const Cuts cuts = cuts_of_equal_share(positions, 8, 0.01);
        ASSERT_EQ(cuts.red.size(), 9U);
        ASSERT_EQ(cuts.black.size(), 10U);
        const auto held = [&](double low, double high) {
            double sum = 0;
            for (const auto& [place, weight] : positions) {
                sum += low <= place && place < high ? static_cast<double>(weight) : 0;
            }
            return sum;
        };
        for (std::size_t i = 0; i < 8; ++i) {
            EXPECT_NEAR(held(cuts.red[i], cuts.red[i + 1]), total / 8, 20) << "red " << i;
        }
        for (std::size_t i = 1; i < 8; ++i) {
            EXPECT_NEAR(held(cuts.black[i], cuts.black[i + 1]), total / 8, 20) << "black " << i;
            EXPECT_NEAR(held(cuts.black[i], cuts.red[i]), total / 16, 20) << "not in the middle";
        }
        EXPECT_NEAR(held(cuts.black[8], infinity) + held(-infinity, cuts.black[1]), total / 8, 20);
        const Cuts wide = cuts_of_equal_share(positions, 8, 0.2);
        EXPECT_LT(wide.red.size(), 7U);
        EXPECT_GE(wide.red.size(), 3U);
        EXPECT_GE(wide.red[1], 0.2);
        EXPECT_LE(wide.red[wide.red.size() - 2], 0.8);
        for (const auto* list : {&wide.red, &wide.black}) {
            for (std::size_t i = 1; i + 2 < list->size(); ++i) {
                EXPECT_GE((*list)[i + 1] - (*list)[i], 0.2);
            }
        }
    }
}

TEST(Cuts, CoverEverything) {
    Dice dice(2);
    for (const double least : {0.0, 0.05, 0.5, 5.0}) {
        for (const std::uint32_t slabs : {1U, 2U, 3U, 8U, 100U}) {
            Positions positions;
            for (int i = dice.in(0, 300); i > 0; --i) {
                positions.emplace_back(dice.in(-1.0, 1.0), 1.0F);
            }
            for (const Cuts& cuts : {cuts_of_equal_share(positions, slabs, least),
                                     cuts_of_equal_width(-1, 1, slabs, least)}) {
                for (const auto* list : {&cuts.red, &cuts.black}) {
                    ASSERT_GE(list->size(), 2U);
                    EXPECT_EQ(list->front(), -infinity);
                    EXPECT_EQ(list->back(), infinity);
                    EXPECT_TRUE(std::is_sorted(list->begin(), list->end()));
                    for (const bool round : {false, true}) {
                        const Colour colour = slab_colour(*list, 0.6, 0.8, round);
                        for (int i = 0; i < 20; ++i) {
                            const double s = i < 2 ? (i == 0 ? -1e9 : 1e9) : dice.in(-2.0, 2.0);
                            EXPECT_LT(colour.locate(0, 0.6 * s, 0.8 * s), colour.regions.size());
                        }
                    }
                }
            }
        }
    }
}

// Black slabs straddle the cuts of the red ones: what one colour locks, the other does not. If red
// cuts are left out because slabs would be too thin, the black ones are left out with them.
TEST(Cuts, OfTheTwoColoursLieApart) {
    Dice dice(3);
    for (int round = 0; round < 200; ++round) {
        const double least = round == 0 ? 0.1 : dice.in(0.02, 0.3);
        const std::uint32_t slabs = round == 0 ? 8 : test::number_in(dice, 2, 12);
        const Cuts cuts = cuts_of_equal_width(0, 1, slabs, least);
        if (round == 0) {
            ASSERT_EQ(cuts.red.size(), 9U);
            ASSERT_EQ(cuts.black.size(), 10U);
        }
        for (std::size_t i = 1; i + 1 < cuts.red.size(); ++i) {
            double nearest = infinity;
            for (const double black : cuts.black) {
                nearest = std::min(nearest, std::abs(black - cuts.red[i]));
            }
            EXPECT_GE(nearest, 0.5 * least - 1e-12) << "red cut at " << cuts.red[i] << " of "
                                                    << slabs << " slabs, least width " << least;
        }
    }
}

SlabOptions slab_options(Slabbing slabbing, std::uint32_t submeshes, double degrees = 0) {
    return {.slabbing = slabbing, .submeshes = submeshes, .degrees = degrees, .least_width = 3};
}

TEST(Slabs, OfTheSecondColourAreJoinedAtTheEnds) {
    Divided disc(test::disc_complex<double>(0.01), 0.01);
    SlabPartitioner<double> partitioner(slab_options(Slabbing::fixed, 6));
    disc.divide(partitioner);
    ASSERT_EQ(disc.partition.colours.size(), 2U);
    ASSERT_EQ(disc.regions(0).size(), 6U);
    ASSERT_EQ(disc.regions(1).size(), 6U) << "as many, though there is one cut more";
    const Colour& black = disc.partition.colours[1];
    EXPECT_EQ(black.locate(0, -1e9, 0.3), black.locate(0, 1e9, 0.8));
    EXPECT_NE(black.locate(0, 1e9, 0.3), black.locate(0, 0.5, 0.3));
    const Colour& red = disc.partition.colours[0];
    EXPECT_NE(red.locate(0, -1e9, 0.3), red.locate(0, 1e9, 0.3));
    // The one at the ends waits for both ends, and for nothing in between.
    const Region& ring = black.regions[black.locate(0, 1e9, 0)];
    const std::vector<bool> meets{true, false, false, false, false, true};
    for (std::size_t i = 0; i < red.regions.size(); ++i) {
        EXPECT_EQ(ring.may_meet(red.regions[i]), meets[i]) << "red " << i;
    }
}

// The share of the weight that each region of a colour holds.
std::vector<double> shares_of(const Divided& divided, std::size_t colour) {
    std::vector<double> shares(divided.regions(colour).size(), 0);
    double total = 0;
    for (std::size_t i = 0; i < divided.interface.size(); ++i) {
        const Point<double> p = divided.position(i);
        const auto work = static_cast<double>(divided.work[i]);
        shares.at(divided.partition.colours[colour].locate(no_id, p.x(), p.y())) += work;
        total += work;
    }
    for (double& share : shares) {
        share /= total;
    }
    return shares;
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
        for (const double share : shares_of(disc, 0)) {
            EXPECT_NEAR(share, 0.2, 0.02) << degrees << " degrees";
        }
        // Of all vertices, whatever their work.
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

Complex<double> ellipse_complex(double h, double degrees) {
    const double turn = degrees * std::numbers::pi / 180;
    const Point<double> along(std::cos(turn), std::sin(turn));
    const Point<double> across(-along.y(), along.x());
    std::vector<Point<double>> points;
    for (const auto& p : test::circle_points({0, 0}, 1, 120)) {
        points.emplace_back(Point<double>(0.5, 0.5) + 0.35 * p.x() * along + 0.12 * p.y() * across);
    }
    const std::vector<Shape> shapes{{points, 1}};
    return initial_complex<double>({}, shapes, {.edge_length = h});
}

TEST(Slabs, FollowTheShape) {
    for (const double degrees : {30.0, 0.0, 90.0, 150.0}) {
        Divided ellipse(ellipse_complex(0.01, degrees), 0.01);
        SlabOptions options = slab_options(Slabbing::active, 4, 77);
        options.follow_shape = true;
        SlabPartitioner<double> partitioner(options);
        ellipse.divide(partitioner);
        ASSERT_EQ(ellipse.regions(0).size(), 4U);
        const double turn = degrees * std::numbers::pi / 180;
        for (const Region& region : ellipse.regions(0)) {
            const double cosine =
                region.normal_x * std::cos(turn) + region.normal_y * std::sin(turn);
            EXPECT_GT(std::abs(cosine), std::cos(3 * std::numbers::pi / 180)) << degrees;
        }
    }
}

// The domain does not change: slabs that follow the shape need not look through the mesh again.
TEST(Slabs, KnowHowFarTheDomainReachesAlongEveryDirection) {
    Divided ellipse(ellipse_complex(0.01, 30), 0.01);
    const Complex<double> first = ellipse.complex;
    SlabOptions options = slab_options(Slabbing::fixed, 4, 77);
    options.follow_shape = true;
    SlabPartitioner<double> partitioner(options);
    for (int turn = 0; turn < 5; ++turn) {
        ellipse.divide(partitioner);
        const std::vector<Region>& slabs = ellipse.regions(0);
        ASSERT_EQ(slabs.size(), 4U);
        double low = infinity;
        double high = -infinity;
        for (const auto& record : first.vertices) {
            low = std::min(low, slabs[1].along(record.x, record.y));
            high = std::max(high, slabs[1].along(record.x, record.y));
        }
        EXPECT_NEAR(slabs[1].high - slabs[1].low, (high - low) / 4, 1e-12) << turn;
        EXPECT_NEAR(slabs[1].high, (low + high) / 2, 1e-12) << turn;
        // The shape turns, and all else is gone from where it was looked at.
        for (std::uint32_t v = 0; v < ellipse.complex.vertex_bound(); ++v) {
            const Point<double> p = ellipse.complex.position(Vertex{v}) - Point<double>(0.5, 0.5);
            const bool is_on = std::ranges::find(ellipse.interface, v) != ellipse.interface.end();
            ellipse.complex.set_position(
                Vertex{v},
                Point<double>(0.5, 0.5) +
                    (is_on ? Point<double>(0.8 * p.x() - 0.6 * p.y(), 0.6 * p.x() + 0.8 * p.y())
                           : Point<double>(0, 0)));
        }
    }
}

// --- blocks -------------------------------------------------------------------------------------

TEST(Blocks, AreSquaresShiftedByThirds) {
    constexpr double h = 0.01;
    Divided disc(test::disc_complex<double>(h, {0.5, 0.5}, 0.25), h);
    BlockPartitioner<double> partitioner({.submeshes = 17, .least_width = 8});
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
    // Nothing is thinner than asked for.
    BlockPartitioner<double> wide({.submeshes = 100, .least_width = 20});
    disc.divide(wide);
    EXPECT_EQ(disc.regions(0).size(), 4U);
    BlockPartitioner<double> too_wide({.submeshes = 100, .least_width = 60});
    disc.divide(too_wide);
    ASSERT_EQ(disc.partition.colours.size(), 1U);
    EXPECT_TRUE(disc.regions(0).front().is_whole());
}

// --- cells --------------------------------------------------------------------------------------

// The distance of a place from the sides of its region.
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
            {.submeshes = cells, .least_vertices = 6, .least_width = 4});
        scene.divide(partitioner);
        const auto shares = shares_of(scene, 0);
        EXPECT_LE(shares.size(), cells);
        if (shares.size() == cells) {
            ++divided_as_asked;
            const auto [least, most] = bounds_of(cells, CutRules{}.tolerance);
            for (const double share : shares) {
                EXPECT_GE(share, least - 1e-6) << "seed " << seed << ", cells " << cells;
                EXPECT_LE(share, most + 1e-6) << "seed " << seed << ", cells " << cells;
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
        const std::uint32_t least_vertices = test::number_in(dice, 5, 30);
        const double least_width = dice.in(3.0, 12.0);
        CellPartitioner<double> partitioner(
            {.submeshes = 12, .least_vertices = least_vertices, .least_width = least_width});
        scene.divide(partitioner);
        const auto& regions = scene.regions(0);
        cells += regions.size();
        std::vector<std::uint32_t> count(regions.size(), 0);
        for (std::size_t i = 0; i < scene.interface.size(); ++i) {
            const Point<double> p = scene.position(i);
            ++count.at(scene.partition.colours[0].locate(no_id, p.x(), p.y()));
        }
        for (std::size_t i = 0; i < regions.size() && regions.size() > 1; ++i) {
            EXPECT_GE(count[i], least_vertices) << "seed " << seed << ", cell " << i;
            EXPECT_GE(regions[i].high - regions[i].low, least_width * scene.h);
            EXPECT_GE(regions[i].side_high - regions[i].side_low, least_width * scene.h);
        }
    }
    EXPECT_GT(cells, 100U);
}

// What the first colour left over at its cuts, the second does away from its own cuts.
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

TEST(Cells, AreCutWhereFewInterfaceVerticesLie) {
    // Two discs: between them there is nothing.
    constexpr double h = 0.01;
    const std::vector<Shape> shapes{{test::circle_points({0.25, 0.5}, 0.15, 100), 1},
                                    {test::circle_points({0.75, 0.5}, 0.15, 100), 1}};
    Divided discs(initial_complex<double>({}, shapes, {.edge_length = h}), h);
    CellPartitioner<double> partitioner({.submeshes = 2});
    discs.divide(partitioner);
    ASSERT_EQ(discs.regions(0).size(), 2U);
    for (std::size_t i = 0; i < discs.interface.size(); ++i) {
        EXPECT_GT(depth(discs.partition.colours[0], discs.position(i)), 5 * h);
    }
    EXPECT_EQ(discs.partition.colours.size(), 1U) << "nothing is left for another colour";
}

// The application need not choose the number of cells; small interfaces are not divided at all.
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
} // namespace dsc
