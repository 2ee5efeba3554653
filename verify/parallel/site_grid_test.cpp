// SPDX-License-Identifier: MIT
// The nearest site by the grid is the one that a search of all sites finds, including ties and
// rounding; and Voronoi regions search no more often than necessary.
#include "thesis/divisions/site_grid.h"

#include "support/random/scene.h"
#include "support/random/submeshes.h"

#include "dsc/parallel/partition/partition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace dsc::site_grid_test {
namespace {

using test::Dice;

std::uint32_t nearest_of_all(const std::vector<Point<double>>& sites, double x, double y) {
    std::uint32_t best = 0;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
        const double squared = (sites[i] - Point<double>(x, y)).squaredNorm();
        if (squared < smallest) {
            smallest = squared;
            best = i;
        }
    }
    return best;
}

// Sites spread over a box, along a line, on a lattice (ties), in clusters, or all in one place.
std::vector<Point<double>> random_sites(Dice& dice, double scale, const Point<double>& offset) {
    std::vector<Point<double>> sites;
    const int kind = dice.in(0, 4);
    const int count = dice.in(1, dice.chance(0.2) ? 8 : 90);
    const double flatness = dice.chance(0.3) ? 0 : dice.in(0.0, 1.0);
    for (int i = 0; i < count; ++i) {
        Point<double> p = dice.point(0, 1);
        p.y() *= flatness;
        if (kind == 1) {
            p = {std::floor(6 * p.x()), std::floor(6 * p.y())};
        } else if (kind == 2) {
            p = Point<double>(i % 3, i % 2) + 1e-3 * p;
        } else if (kind == 3) {
            p = {0.5, 0.25};
        }
        sites.emplace_back(offset + scale * p);
    }
    return sites;
}

TEST(SiteGrid, FindsWhatASearchThroughAllFinds) {
    constexpr double largest = std::numeric_limits<double>::max();
    int ties = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Dice dice(seed);
        const double scale = std::pow(10.0, dice.chance(0.3) ? dice.in(-160, 160) : dice.in(-3, 3));
        // With an offset, the sites are only a few units of rounding apart.
        const Point<double> offset =
            dice.chance(0.3) ? Point<double>(1e13 * scale, -3e14 * scale) : Point<double>(0, 0);
        const auto sites = random_sites(dice, scale, offset);
        const SiteGrid grid(sites);
        const auto expect_same = [&](double x, double y) {
            ASSERT_EQ(grid.nearest(x, y), nearest_of_all(sites, x, y)) << x << ", " << y;
        };
        for (int i = 0; i < 200; ++i) {
            // Among the sites, beside them, and far away.
            const double reach = i % 4 == 0 ? 30 : i % 4 == 1 ? 1e9 : 1.5;
            const Point<double> p = offset + scale * reach * dice.point(-1, 1);
            expect_same(p.x(), p.y());
            // The middle between two sites, and the place of a site, which other sites may share.
            const auto any = [&] {
                return sites[static_cast<std::size_t>(
                    dice.in(0, static_cast<int>(sites.size()) - 1))];
            };
            const Point<double> a = any();
            const Point<double> b = any();
            const Point<double> middle = a + 0.5 * (b - a);
            ties += a != b && (a - middle).squaredNorm() == (b - middle).squaredNorm() ? 1 : 0;
            expect_same(middle.x(), middle.y());
            expect_same(a.x(), a.y());
        }
        for (const double far : {largest, -largest, std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()}) {
            expect_same(far, 0);
            expect_same(0, far);
        }
    }
    EXPECT_GT(ties, 1000);
}

} // namespace
} // namespace dsc::site_grid_test
