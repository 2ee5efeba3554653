// SPDX-License-Identifier: MIT
// Voronoi diagrams against their definition.
#include "shapes/voronoi.h"

#include "dsc/base/error.h"
#include "dsc/geometry/predicates.h"
#include "support/initial_testing.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
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

double total_area(const std::vector<Outline>& cells) {
    return signed_area(std::span<const Outline>(cells));
}

TEST(Voronoi, ThePointsOfACellAreNearestToItsSite) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    for (const Rectangle& domain : {Rectangle{}, wide}) {
        const Sites sites = random_sites(domain, 300, 7);
        const auto cells = voronoi_cells(domain, sites);
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

TEST(Voronoi, CurvesSeparateTheCellsThatTheyName) {
    const Sites sites = random_sites(wide, 400, 11);
    const auto curves = voronoi_curves(wide, sites);
    std::map<Place, int> ends;
    for (const Curve& curve : curves) {
        ASSERT_EQ(curve.points.size(), 2U);
        const Point<double>& left = sites[curve.left - 1];
        const Point<double>& right = sites[curve.right - 1];
        EXPECT_GT(orientation<double>(curve.points[0], curve.points[1], left), 0);
        EXPECT_LT(orientation<double>(curve.points[0], curve.points[1], right), 0);
        for (const Point<double>& p : curve.points) {
            EXPECT_NEAR((p - left).norm(), (p - right).norm(), 1e-11);
            ++ends[place(p)];
        }
    }
    // Three ends at the same bits meet inside, and one on a side.
    std::size_t junctions = 0;
    std::size_t on_sides = 0;
    for (const auto& [p, count] : ends) {
        const bool on_side = p.first == wide.low.x() || p.first == wide.high.x() ||
                             p.second == wide.low.y() || p.second == wide.high.y();
        EXPECT_EQ(count, on_side ? 1 : 3);
        (on_side ? on_sides : junctions) += 1;
    }
    EXPECT_GT(on_sides, 10U);
    EXPECT_EQ(junctions + sites.size(), curves.size() + 1) << "Euler's formula";
}

TEST(Voronoi, TwoSitesMakeOneCurve) {
    const Sites sites{{0.25, 0.4}, {0.75, 0.4}};
    const auto curves = voronoi_curves({}, sites);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(curves[0].points, (Sites{{0.5, 0}, {0.5, 1}}));
    EXPECT_EQ(curves[0].left, 1U);
    EXPECT_EQ(curves[0].right, 2U);
    const Sites one{{0.3, 0.1}};
    EXPECT_EQ(total_area(voronoi_cells({}, one)), 1);
}

// Which site has which number, and whether a site lies on a side, is no matter.
TEST(Voronoi, TakesSitesInAnyOrderAndOnTheSides) {
    Sites sites = random_sites({}, 50, 3);
    sites.emplace_back(0, 0.5);
    sites.emplace_back(1, 1);
    const auto cells = voronoi_cells({}, sites);
    EXPECT_NEAR(total_area(cells), 1, 1e-14);
    Sites reversed_sites(sites.rbegin(), sites.rend());
    const auto others = voronoi_cells({}, reversed_sites);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        EXPECT_NEAR(signed_area(cells[i]), signed_area(others[cells.size() - 1 - i]), 1e-15);
    }
    EXPECT_FALSE(voronoi_curves({}, sites, {.shortest = 0.02}).empty());
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
        const auto whole = voronoi_cells({}, sites);
        const auto cells = voronoi_cells({}, sites, {.shortest = shortest});
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

// An edge that becomes too short only as a neighbour of it is contracted.
TEST(VoronoiShortEdges, ThatCameLaterAreContractedAsWell) {
    const double shortest = 0.025;
    const Sites sites = random_sites({}, 300, 6);
    const auto length = [](const std::vector<Curve>& curves) {
        for (const Curve& curve : curves) {
            if (curve.left == 16 && curve.right == 99) {
                return (curve.points[1] - curve.points[0]).norm();
            }
        }
        return 0.0;
    };
    EXPECT_GE(length(voronoi_curves({}, sites)), shortest);
    EXPECT_EQ(length(voronoi_curves({}, sites, {.shortest = shortest})), 0);
}

// Four sites nearly on a circle: two vertices become one, halfway between them; the edge between
// the two cells that have lost touch is gone.
TEST(VoronoiShortEdges, FourCellsMeetInTheMiddleOfTheEdge) {
    const Sites sites{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.701}, {0.3, 0.7}};
    const auto whole = voronoi_curves({}, sites);
    const auto curves = voronoi_curves({}, sites, {.shortest = 0.01});
    ASSERT_EQ(whole.size(), 5U);
    ASSERT_EQ(curves.size(), 4U);
    Point<double> middle(0, 0);
    for (const Curve& curve : whole) {
        const Point<double> half = (curve.points[0] + curve.points[1]) / 2;
        middle = (curve.points[1] - curve.points[0]).norm() < 0.01 ? half : middle;
    }
    std::map<Place, int> ends;
    for (const Curve& curve : curves) {
        ++ends[place(curve.points[0])];
        ++ends[place(curve.points[1])];
    }
    EXPECT_EQ(ends.size(), 5U);
    EXPECT_EQ(ends[place(middle)], 4);
}

// The cell of the third site has a short side at the bottom of the domain.
TEST(VoronoiShortEdges, PiecesOfTheSidesAreContractedToTheirMiddle) {
    const Sites sites{{0.3, 0.1}, {0.7, 0.1}, {0.5, 0.223}, {0.2, 0.8}, {0.8, 0.81}};
    const auto lowest = [](const std::vector<Curve>& curves) {
        std::set<double> x;
        for (const Curve& curve : curves) {
            for (const Point<double>& p : curve.points) {
                if (p.y() == 0) {
                    x.insert(p.x());
                }
            }
        }
        return std::vector<double>(x.begin(), x.end());
    };
    const auto before = lowest(voronoi_curves({}, sites));
    ASSERT_EQ(before.size(), 2U);
    EXPECT_NEAR(before[1] - before[0], 0.00135, 1e-4);
    const auto after = lowest(voronoi_curves({}, sites, {.shortest = 0.01}));
    ASSERT_EQ(after.size(), 1U);
    EXPECT_NEAR(after[0], (before[0] + before[1]) / 2, 1e-16);
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

TEST(VoronoiSites, RelaxationMakesCellsAlike) {
    const Sites sites = random_sites(wide, 500, 5);
    const auto spread = [](const Sites& places) {
        double squares = 0;
        for (const Outline& cell : voronoi_cells(wide, places)) {
            squares += signed_area(cell) * signed_area(cell);
        }
        return squares / 500 / std::pow(16.0 / 500, 2) - 1;
    };
    EXPECT_NEAR(spread(sites), 0.28, 0.06) << "the known variance of cells of random sites";
    EXPECT_LT(spread(relaxed_sites(wide, sites, 5)), 0.09);
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

template <class Call>
void expect_error(const Call& call, const std::string& where, const std::string& words) {
    try {
        static_cast<void>(call());
        ADD_FAILURE() << "no error; expected: " << where << ": " << words;
    } catch (const InputError& error) {
        EXPECT_EQ(error.where(), where) << error.what();
        EXPECT_NE(error.problem().find(words), std::string::npos) << error.what();
        EXPECT_FALSE(error.value().empty());
        EXPECT_FALSE(error.allowed().empty());
    }
}

void expect_error(const Sites& sites, const std::string& where, const std::string& words) {
    expect_error([&] { return voronoi_curves({}, sites); }, where, words);
}

TEST(VoronoiErrors, Sites) {
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    expect_error(Sites{}, "number of sites", "out of range");
    expect_error(Sites{{0.5, 0.5}}, "number of sites", "out of range");
    expect_error(Sites{{0.5, 0.5}, {1.5, 0.5}}, "site 1", "not in the domain");
    expect_error(Sites{{0.5, not_a_number}, {0.5, 0.5}}, "site 0", "not in the domain");
    expect_error(Sites{{0.2, 0.5}, {0.7, 0.5}, {0.2, 0.5}}, "site 0", "coincide");
    expect_error(Sites{{0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}}, "site 0, site 1, site 2",
                 "cocircular");
    // The bisector goes through two corners of the domain.
    expect_error(Sites{{0.25, 0.75}, {0.75, 0.25}}, "site 0, site 1, side 0", "corner");
}

TEST(VoronoiErrors, DomainAndOptions) {
    const Sites sites{{0.25, 0.5}, {0.75, 0.5}};
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Rectangle& bad :
         {Rectangle{{0, 0}, {0, 1}}, Rectangle{{0, 0}, {1, infinity}}, Rectangle{{1, 1}, {0, 0}}}) {
        expect_error([&] { return voronoi_cells(bad, sites); }, "domain", "empty");
    }
    for (const double bad : {-1.0, infinity, std::nan("")}) {
        expect_error([&] { return voronoi_curves({}, sites, {.shortest = bad}); }, "shortest",
                     "out of range");
    }
    expect_error([&] { return relaxed_sites({}, sites, -1); }, "rounds of relaxation",
                 "out of range");
}

// Not only a few sites at once: lattices are cocircular everywhere, unless they are hexagonal.
TEST(VoronoiErrors, LatticesAreRefusedUnlessTheyAreHexagonal) {
    Sites square;
    Sites hexagonal;
    for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
            square.emplace_back((column + 0.5) / 8, (row + 0.5) / 8);
            hexagonal.emplace_back((column + 0.3 + 0.5 * (row % 2)) / 8.5, (row + 0.5) / 8);
        }
    }
    EXPECT_THROW(static_cast<void>(voronoi_curves({}, square)), InputError);
    EXPECT_NEAR(total_area(voronoi_cells({}, hexagonal)), 1, 1e-13);
}

} // namespace

} // namespace dsc::scenes::voronoi_test
