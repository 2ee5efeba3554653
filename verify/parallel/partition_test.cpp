// SPDX-License-Identifier: MIT
// Properties of every partition: each colour covers the plane without overlap, overlapping
// submeshes wait for each other, and equal interfaces are divided equally.
#include "dsc/parallel/partition/partition.h"

#include "support/random/scene.h"
#include "support/random/submeshes.h"
#include "support/refusal.h"

#include "dsc/base/error.h"
#include "thesis/divisions/blocks.h"
#include "thesis/divisions/slabs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace dsc::partition_test {
namespace {

using test::Dice;
using test::Divided;
using test::PartitionFamily;
using test::random_divided;

constexpr double infinity = Region::infinity;

// Points in and around the mesh, far away, and on the cuts.
std::vector<Point<double>> sample_points(Dice& dice, const Divided& divided) {
    std::vector<Point<double>> points;
    for (int i = 0; i < 300; ++i) {
        points.push_back(dice.point(-0.5, 1.5));
    }
    for (std::size_t i = 0; i < divided.interface.size(); i += 3) {
        points.push_back(divided.position(i));
    }
    for (const double far : {1e3, 1e12, 1e300}) {
        for (int i = 0; i < 8; ++i) {
            const double angle = dice.in(0.0, 6.3);
            points.emplace_back(far * std::cos(angle), far * std::sin(angle));
        }
        points.insert(points.end(), {{far, 0}, {-far, 0}, {0, far}, {0, -far}});
    }
    for (const Colour& colour : divided.partition.colours) {
        for (const Region& region : colour.regions) {
            if (region.kind != Region::Kind::box) {
                continue;
            }
            const Point<double> normal(region.normal_x, region.normal_y);
            const Point<double> side(-region.normal_y, region.normal_x);
            for (const double u : {region.low, region.high}) {
                if (std::isfinite(u)) {
                    points.emplace_back(u * normal + dice.in(-1.0, 2.0) * side);
                    for (const double w : {region.side_low, region.side_high}) {
                        if (std::isfinite(w)) {
                            points.emplace_back(u * normal + w * side); // a corner
                        }
                    }
                }
            }
            for (const double w : {region.side_low, region.side_high}) {
                if (std::isfinite(w)) {
                    points.emplace_back(dice.in(-1.0, 2.0) * normal + w * side);
                }
            }
        }
    }
    return points;
}

class EveryPartition : public testing::TestWithParam<PartitionFamily> {};

TEST_P(EveryPartition, CoversThePlaneWithoutOverlap) {
    std::size_t several = 0;
    constexpr std::uint64_t seeds = 30;
    for (std::uint64_t seed = 1; seed <= seeds && !HasFailure(); ++seed) {
        Dice dice(seed);
        Divided divided = random_divided(dice, seed % 3 == 0);
        SCOPED_TRACE("seed " + std::to_string(seed));
        const auto partitioner = test::random_partitioner<double>(dice, GetParam());
        divided.divide(*partitioner);
        const auto first = divided.regions(0).size();
        several += first >= 3 ? 1 : 0;
        if (seed % 2 == 0) {
            const std::size_t colours = divided.partition.colours.size();
            divided.divide(*partitioner, Recut::later); // later colours may be cut anew at any time
            ASSERT_EQ(divided.regions(0).size(), first);
            ASSERT_EQ(divided.partition.colours.size(), colours);
        }
        const auto& colours = divided.partition.colours;
        for (const auto& p : sample_points(dice, divided)) {
            std::vector<std::size_t> owners;
            for (const Colour& colour : colours) {
                ASSERT_GE(colour.regions.size(), 1U);
                const auto owns = [&](const Region& r) { return r.owns(no_id, p.x(), p.y()); };
                ASSERT_EQ(std::ranges::count_if(colour.regions, owns), 1)
                    << p.x() << ' ' << p.y() << ", colour " << &colour - colours.data();
                owners.push_back(colour.locate(no_id, p.x(), p.y()));
                EXPECT_TRUE(owns(colour.regions.at(owners.back())));
                const auto hint = test::number_in(dice, 0, 40);
                EXPECT_EQ(colour.locate(no_id, p.x(), p.y(), hint), owners.back());
            }
            // Submeshes that overlap must wait for each other.
            for (std::size_t c = 1; c < owners.size(); ++c) {
                const Region& one = colours[c - 1].regions[owners[c - 1]];
                const Region& other = colours[c].regions[owners[c]];
                EXPECT_TRUE(one.may_meet(other) && other.may_meet(one))
                    << p.x() << ' ' << p.y() << ", colours " << c - 1 << " and " << c;
            }
        }
        // Not every submesh waits for every other one: boxes of one colour do not meet.
        for (const Colour& colour : colours) {
            for (const Region& a : colour.regions) {
                for (const Region& b : colour.regions) {
                    EXPECT_TRUE(&a == &b || GetParam() == PartitionFamily::voronoi ||
                                !a.may_meet(b));
                }
            }
        }
    }
    EXPECT_GE(several, seeds / 2) << "there was little to divide";
}

// Partitioners keep no state: equal inputs are divided equally, by any object and at any call.
TEST_P(EveryPartition, IsTheSameForTheSameInterface) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Dice dice(seed);
        Divided divided = random_divided(dice, seed % 3 == 0);
        Divided other = random_divided(dice, false);
        Dice again = dice;
        const auto used = test::random_partitioner<double>(dice, GetParam());
        const auto fresh = test::random_partitioner<double>(again, GetParam());
        other.divide(*used);
        divided.divide(*used);
        const auto expected = divided.partition;
        std::vector<std::size_t> places;
        const auto points = sample_points(dice, divided);
        for (const Colour& colour : expected.colours) {
            for (const auto& p : points) {
                places.push_back(colour.locate(no_id, p.x(), p.y()));
            }
        }
        divided.divide(*fresh);
        ASSERT_EQ(divided.partition.colours.size(), expected.colours.size());
        std::size_t i = 0;
        for (const Colour& colour : divided.partition.colours) {
            for (const auto& p : points) {
                EXPECT_EQ(colour.locate(no_id, p.x(), p.y()), places.at(i++));
            }
        }
    }
}

TEST_P(EveryPartition, DividesNothingWhereThereIsNoInterface) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Dice dice(seed);
        Divided divided(initial_complex<double>({}, {}, {.edge_length = 0.1}), 0.1);
        divided.interface.clear();
        divided.work.clear();
        const auto partitioner = test::random_partitioner<double>(dice, GetParam());
        divided.divide(*partitioner);
        for (const auto& p : sample_points(dice, divided)) {
            for (const Colour& colour : divided.partition.colours) {
                EXPECT_LT(colour.locate(no_id, p.x(), p.y()), colour.regions.size());
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Partitions, EveryPartition,
                         testing::ValuesIn(test::all_partition_families),
                         [](const auto& one) { return std::string(to_string(one.param)); });

// --- options ------------------------------------------------------------------------------------

template <class Options>
struct Seeded {
    const char* where;
    std::function<void(Options&)> seed;
};

template <class Partitioner, class Options>
void expect_refused(const std::vector<Seeded<Options>>& faults) {
    const Partitioner good{Options{}};
    for (const auto& fault : faults) {
        Options options;
        fault.seed(options);
        test::expect_refusal([&] { const Partitioner bad{options}; }, fault.where);
    }
}

TEST(Partitioners, RefuseOptionsThatMakeNoSense) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    expect_refused<SlabPartitioner<double>, SlabOptions>(
        {{"submeshes", [](SlabOptions& s) { s.submeshes = 0; }},
         {"submeshes", [](SlabOptions& s) { s.submeshes = 65537; }},
         {"degrees", [](SlabOptions& s) { s.degrees = nan; }},
         {"degrees", [](SlabOptions& s) { s.degrees = infinity; }},
         {"min_width", [](SlabOptions& s) { s.min_width = 1.9; }},
         {"min_width", [](SlabOptions& s) { s.min_width = nan; }},
         {"recut", [](SlabOptions& s) { s.recut = 0; }}});
    expect_refused<BlockPartitioner<double>, BlockOptions>(
        {{"submeshes", [](BlockOptions& s) { s.submeshes = 0; }},
         {"submeshes", [](BlockOptions& s) { s.submeshes = 65537; }},
         {"min_width", [](BlockOptions& s) { s.min_width = 1.9; }},
         {"min_width", [](BlockOptions& s) { s.min_width = nan; }},
         {"recut", [](BlockOptions& s) { s.recut = 0; }}});
    expect_refused<CellPartitioner<double>, CellOptions>(
        {{"submeshes", [](CellOptions& s) { s.submeshes = 65537; }},
         {"min_width", [](CellOptions& s) { s.min_width = 1.9; }},
         {"min_width", [](CellOptions& s) { s.min_width = nan; }},
         {"min_width", [](CellOptions& s) { s.min_width = infinity; }},
         {"band", [](CellOptions& s) { s.band = -1; }},
         {"band", [](CellOptions& s) { s.band = nan; }},
         {"band", [](CellOptions& s) { s.band = infinity; }},
         {"recut", [](CellOptions& s) { s.recut = 0; }},
         {"recut", [](CellOptions& s) { s.recut_later = 0; }}});
}

TEST(Partitioners, RefuseColoursThatMakeNoSense) {
    using Colours = std::vector<PlaceColour>;
    const auto none = [](double, double) { return 0U; };
    EXPECT_THROW(PlacePartitioner<double>(nullptr), InputError);
    EXPECT_THROW(PlacePartitioner<double>([](const auto&) { return Colours{}; }, 0), InputError);
    for (const Colours& colours :
         {Colours{}, Colours{{none, 0}}, Colours{{nullptr, 2}}, Colours{{none, 1}, {none, 0}}}) {
        Divided disc(test::disc_complex<double>(0.1), 0.1);
        PlacePartitioner<double> partitioner(
            [&](const PartitionInput<double>&) { return colours; });
        EXPECT_THROW(disc.divide(partitioner), InputError);
        EXPECT_TRUE(disc.partition.colours.empty()) << "a refused partition was put in force";
    }
}

} // namespace
} // namespace dsc::partition_test
