// SPDX-License-Identifier: MIT
// The smallest numbers of slabs, and divisions into a single submesh.
#include "dsc/base/error.h"
#include "dsc/parallel/executors.h"
#include "dsc/parallel/in_place/submesh_executor.h"
#include "dsc/parallel/parallel.h"
#include "dsc/parallel/partition/cuts.h"

#include "support/random/scene.h"
#include "support/small_meshes.h"
#include "thesis/divisions/blocks.h"
#include "thesis/divisions/slabs.h"
#include "thesis/divisions/voronoi.h"

#include <gtest/gtest.h>

#include <vector>

namespace dsc::limits_test {
namespace {

TEST(CutLimits, TwoSitesAreEnoughForTwoCells) {
    std::vector<Site> sites{{0, 0, 1}, {10, 0, 1}};
    const std::vector<Region> cells = divide_sites(sites, 2, {.tolerance = 0.5});
    ASSERT_EQ(cells.size(), 2U);
    EXPECT_EQ(cells[0].high, 5);
}

TEST(CutLimits, LaterColoursAreCutAnewInBetween) {
    const CellPartitioner<double> cells({.recut = 8, .recut_later = 3});
    const auto due = [&](std::uint64_t steps) {
        return cells.is_due({.step = 100, .steps_since_all = steps, .interface_vertices = 500});
    };
    EXPECT_EQ(due(2), Recut::none);
    EXPECT_EQ(due(3), Recut::later);
    EXPECT_EQ(due(4), Recut::none);
    EXPECT_EQ(due(6), Recut::later);
    EXPECT_EQ(due(7), Recut::none);
    EXPECT_EQ(due(8), Recut::all);
}

// A list of the vertices on the upper side of a square, which are 1 apart.
class OnARow : public testing::Test {
protected:
    OnARow() {
        for (std::uint32_t i = 0; i <= 12; ++i) {
            row.push_back(12 * 13 + i);
        }
        work.assign(row.size(), 1);
    }
    PartitionInput<double> input(double edge_length) const {
        return {mesh, row, work, edge_length};
    }

    Complex<double> mesh = test::grid<double>(12);
    std::vector<std::uint32_t> row;
    std::vector<float> work;
};

// Regions meet only where consecutive vertices of the interface belong to different regions, not at
// a gap in the list.
TEST_F(OnARow, RegionsMeetWhereTheInterfaceGoesOn) {
    EXPECT_EQ(voronoi_colours(input(1.0 / 3), 2).size(), 1U);
    EXPECT_EQ(voronoi_colours(input(1.0 / 3.5), 2).size(), 1U);
    const auto colours = voronoi_colours(input(0.5), 2);
    ASSERT_EQ(colours.size(), 2U);
    EXPECT_EQ(colours[0].submeshes, 2U);
    EXPECT_EQ(colours[1].submeshes, 1U);
}

TEST_F(OnARow, TwoBlocksAreTwo) {
    BlockPartitioner<double> blocks({.submeshes = 4, .min_width = 2});
    Partition partition;
    blocks.divide(input(1), Recut::all, partition);
    ASSERT_GT(partition.colours.size(), 1U);
    EXPECT_EQ(partition.colours.front().regions.size(), 2U);
}

TEST_F(OnARow, ASingleSubmeshIsWhatOneAsksFor) {
    auto complex = test::disc_complex<double>(0.02);
    const Options<double> options{.edge_length = 0.02};
    for (const std::uint32_t submeshes : {1U, 2U, 3U}) {
        const auto executor = make_executor(
            complex, options, Parallel{.division = &counting_division, .submeshes = submeshes});
        const auto* seen = dynamic_cast<const SubmeshExecutor<double>*>(executor.get());
        ASSERT_NE(seen, nullptr);
        EXPECT_EQ(seen->view().partition.colours.front().regions.size(), submeshes);
    }
}

} // namespace
} // namespace dsc::limits_test
