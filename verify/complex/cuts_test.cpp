// SPDX-License-Identifier: MIT
// Places exactly on a cut: one submesh owns them, never two and never none.
#include "dsc/complex/submesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace dsc::cuts_test {
namespace {

// Three by three boxes of side 1, the outer ones without an outer bound.
std::vector<Region> boxes() {
    constexpr std::array cuts{-Region::infinity, 1.0, 2.0, Region::infinity};
    std::vector<Region> regions;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            Region region;
            region.kind = Region::Kind::box;
            region.low = cuts[i];
            region.high = cuts[i + 1];
            region.side_low = cuts[j];
            region.side_high = cuts[j + 1];
            regions.push_back(region);
        }
    }
    return regions;
}

TEST(Cuts, BelongToOneSubmesh) {
    const std::vector<Region> regions = boxes();
    for (const double x : {0.5, 1.0, 1.5, 2.0, 3.0}) {
        for (const double y : {-7.0, 1.0, 2.0, 2.5}) {
            EXPECT_EQ(std::ranges::count_if(
                          regions, [&](const Region& region) { return region.owns(0, x, y); }),
                      1)
                << x << ", " << y;
        }
    }
}

TEST(Cuts, OfSlabsThatWrapAroundBelongToOneOfThem) {
    std::array<Region, 2> regions;
    for (Region& region : regions) {
        region.kind = Region::Kind::box;
    }
    regions[0].low = 1;
    regions[0].high = 2;
    regions[1].low = 2; // and round to 1
    regions[1].high = 1;
    for (const double x : {0.0, 1.0, 1.5, 2.0, 3.0}) {
        EXPECT_NE(regions[0].owns(0, x, 0), regions[1].owns(0, x, 0)) << x;
    }
}

} // namespace
} // namespace dsc::cuts_test
