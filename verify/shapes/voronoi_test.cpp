// SPDX-License-Identifier: MIT
// Voronoi diagrams against their definition.
#include "shapes/voronoi.h"

#include "dsc/base/error.h"
#include "shapes/voronoi_diagram.h"
#include "support/initial_testing.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace dsc::scenes::voronoi_test {
namespace {

using Sites = std::vector<Point<double>>;
using Place = std::pair<double, double>;

const Rectangle wide{{-3, 10}, {5, 12}};

Place place(const Point<double>& p) { return {p.x(), p.y()}; }

std::uint32_t nearest(const Sites& sites, const Point<double>& p) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < sites.size(); ++i) {
        best = (sites[i] - p).norm() < (sites[best] - p).norm() ? i : best;
    }
    return best;
}

std::vector<Outline> cells_of(const Rectangle& domain, const Sites& sites, double shortest = 0) {
    VoronoiDiagram diagram = voronoi_diagram(domain, sites);
    if (shortest > 0) {
        diagram = without_short_edges(std::move(diagram), shortest);
    }
    std::vector<Outline> cells;
    for (const VoronoiCell& cell : diagram.cells) {
        cells.push_back(diagram.corners_of(cell));
    }
    return cells;
}

double total_area(const std::vector<Outline>& cells) {
    return signed_area(std::span<const Outline>(cells));
}

TEST(Voronoi, ThePointsOfACellAreNearestToItsSite) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    for (const Rectangle& domain : {Rectangle{}, wide}) {
        const Sites sites = random_sites(domain, 300, 7);
        const auto cells = cells_of(domain, sites);
        ASSERT_EQ(cells.size(), sites.size());
        const double whole = (domain.high - domain.low).prod();
        EXPECT_NEAR(total_area(cells), whole, 1e-12 * whole);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            EXPECT_TRUE(test::is_inside(cells[i], sites[i])) << "site " << i;
            EXPECT_TRUE(test::is_simple(cells[i])) << "site " << i;
        }
        for (int k = 0; k < 3000; ++k) {
            const double x = share(random);
            const double y = share(random);
            const Point<double> p =
                domain.low + Point<double>(x, y).cwiseProduct(domain.high - domain.low);
            EXPECT_TRUE(test::is_inside(cells[nearest(sites, p)], p)) << p.transpose();
        }
    }
}

TEST(Voronoi, TwoSitesMakeOneCurve) {
    const Sites sites{{0.25, 0.4}, {0.75, 0.4}};
    const auto curves = voronoi_curves({}, sites);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(curves[0].points, (Sites{{0.5, 0}, {0.5, 1}}));
    EXPECT_EQ(curves[0].left, 1U);
    EXPECT_EQ(curves[0].right, 2U);
    const Sites one{{0.3, 0.1}};
    EXPECT_EQ(total_area(cells_of({}, one)), 1);
}

TEST(Voronoi, CocircularSitesShareAVertex) {
    const Sites sites{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}};
    const auto curves = voronoi_curves({}, sites);
    ASSERT_EQ(curves.size(), 4U);
    for (const auto& curve : curves) {
        const Point<double> middle(0.5, 0.5);
        EXPECT_TRUE(curve.points.front() == middle || curve.points.back() == middle);
    }
}

// --- short edges ---------------------------------------------------------------------------------

double shortest_edge(const Outline& cell) {
    double shortest = 1e300;
    for (std::size_t k = 0; k < cell.size(); ++k) {
        shortest = std::min(shortest, (cell[(k + 1) % cell.size()] - cell[k]).norm());
    }
    return shortest;
}

TEST(VoronoiShortEdges, AreContracted) {
    const double shortest = 0.016; // the mean edge is 0.038 long
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Sites sites = random_sites({}, 300, seed);
        const auto whole = cells_of({}, sites);
        const auto cells = cells_of({}, sites, shortest);
        EXPECT_NEAR(total_area(cells), 1, 1e-13);
        std::size_t short_before = 0;
        std::size_t short_after = 0;
        std::set<Place> triangle_corners;
        for (const Outline& cell : cells) {
            for (const Point<double>& p : cell) {
                if (cell.size() == 3) {
                    triangle_corners.insert(place(p));
                }
            }
        }
        for (std::size_t i = 0; i < cells.size(); ++i) {
            ASSERT_GE(cells[i].size(), 3U);
            EXPECT_TRUE(test::is_simple(cells[i]));
            short_before += shortest_edge(whole[i]) < shortest ? 1U : 0U;
            for (std::size_t k = 0; k < cells[i].size(); ++k) {
                const Point<double>& p = cells[i][k];
                const Point<double>& q = cells[i][(k + 1) % cells[i].size()];
                const bool kept =
                    triangle_corners.count(place(p)) > 0 || triangle_corners.count(place(q)) > 0;
                short_after += (q - p).norm() < shortest ? 1U : 0U;
                EXPECT_TRUE((q - p).norm() >= shortest || kept) << "only beside triangles";
            }
        }
        EXPECT_GT(short_before, 100U);
        EXPECT_LT(short_after, 30U);
    }
}

// --- sites ---------------------------------------------------------------------------------------

TEST(VoronoiSites, MoveToTheCentroidsOfTheirCells) {
    const Sites sites{{0.2, 0.5}, {0.6, 0.5}};
    const auto relaxed = relaxed_sites({}, sites, 1);
    EXPECT_NEAR((relaxed[0] - Point<double>(0.2, 0.5)).norm(), 0, 1e-16);
    EXPECT_NEAR((relaxed[1] - Point<double>(0.7, 0.5)).norm(), 0, 1e-15);
    EXPECT_EQ(relaxed_sites({}, sites, 0), sites);
    const auto settled = relaxed_sites({}, sites, 60);
    EXPECT_NEAR((settled[0] - Point<double>(0.25, 0.5)).norm(), 0, 1e-12);
    EXPECT_TRUE(relaxed_sites({}, Sites{}, 3).empty());
}

// The first numbers of SplitMix64 for this seed, as published with it.
TEST(VoronoiSites, RandomOnesAreTheSameEverywhere) {
    const Sites sites = random_sites({}, 2, 1234567);
    const auto fraction = [](std::uint64_t bits) {
        return static_cast<double>(bits >> 11U) / 9007199254740992.0;
    };
    EXPECT_EQ(sites[0],
              Point<double>(fraction(6457827717110365317U), fraction(3203168211198807973U)));
    EXPECT_EQ(sites[1],
              Point<double>(fraction(9817491932198370423U), fraction(4593380528125082431U)));
    const Sites many = random_sites(wide, 2000, 1);
    Point<double> mean(0, 0);
    for (const Point<double>& s : many) {
        EXPECT_TRUE((s.array() >= wide.low.array()).all() && (s.array() < wide.high.array()).all());
        mean += s / 2000;
    }
    EXPECT_NEAR(mean.x(), 1, 0.2);
    EXPECT_NEAR(mean.y(), 11, 0.05);
    EXPECT_NE(random_sites({}, 1, 1)[0], random_sites({}, 1, 2)[0]);
}

// --- errors --------------------------------------------------------------------------------------

void expect_error(const Sites& sites, const std::string& where, const std::string& words) {
    try {
        (void)voronoi_curves({}, sites);
        ADD_FAILURE() << "no error; expected: " << where << ": " << words;
    } catch (const InputError& error) {
        EXPECT_EQ(error.where(), where) << error.what();
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(VoronoiErrors, Sites) {
    expect_error(Sites{{0.2, 0.5}, {0.7, 0.5}, {0.2, 0.5}}, "site 0", "coincide");
    // The bisector goes through two corners of the domain.
    expect_error(Sites{{0.25, 0.75}, {0.75, 0.25}}, "site 0, site 1, side 0, side 3", "corner");
}

} // namespace

} // namespace dsc::scenes::voronoi_test
