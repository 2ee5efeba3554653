// SPDX-License-Identifier: MIT
// Junctions inside and at the sides of the domain: four sectors that split, ends of curves that
// meet on the domain boundary, junctions that reach it, and corners; and the phases that get small
// pieces.

#include "support/topology/topology_testing.h"

#include "dsc/base/error.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace dsc::junctions_test {
namespace {

using test::cells_of;
using test::change;
using test::changing;
using test::Ends;
using test::ends_of;
using test::film;
using test::grid;
using test::Meeting;
using test::meeting_at;
using test::nothing;
using P = Point<double>;

// Phase 2 stands on the domain boundary, 0.1 wide, between 1 and 3; its sides move apart by `slope`
// upwards.
Complex<double> narrow_foot(double slope) {
    std::vector<std::vector<P>> rows;
    for (int y = 0; y <= 4; ++y) {
        auto& row = rows.emplace_back();
        for (const int x : {-3, -2, -1, 1, 2, 3}) {
            const double half = 0.05 + slope * y;
            row.emplace_back(x > 0 ? half + x - 1 : -half + x + 1, y);
        }
    }
    return cells_of(rows, [&](const P& p) {
        const double half = 0.05 + slope * p.y();
        return p.x() < -half ? 1U : (p.x() > half ? 3U : 2U);
    });
}

// Phase 2 is a wedge with its point at (0, height) and sides that rise by `slope`.
Complex<double> wedge(double height, double slope) {
    std::vector<double> ys{0};
    for (int y = height > 0 ? 0 : 1; y <= 3; ++y) {
        ys.push_back(height + slope * y);
    }
    return grid({-4, -3, -2, -1, 0, 1, 2, 3, 4}, ys, [&](const P& p) {
        return p.y() - height > slope * std::abs(p.x()) ? 2U : (p.x() < 0 ? 1U : 3U);
    });
}

std::ptrdiff_t on_floor(const std::vector<P>& places) {
    return std::ranges::count_if(places, [](const P& p) { return p.y() == 0; });
}

Phase phase_at_corner(const Complex<double>& complex, const P& place) {
    for (const Vertex v : vertices(complex)) {
        if (complex.position(v) == place) {
            const Meeting meeting = meeting_at(complex, v);
            return meeting.phases.size() == 1 ? meeting.phases[0] : nothing;
        }
    }
    return nothing;
}

// A curve from the corner (0, 0) that rises by `slope`.
Complex<double> from_corner(double slope) {
    return grid({0, 1, 2, 3, 4}, {0, slope, 2 * slope, 3 * slope, 4 * slope, 5 * slope},
                [&](const P& p) { return p.y() > slope * p.x() ? 1U : 2U; });
}

// --- ends that meet on the domain boundary, and junctions that reach it --------------------------

TEST(BoundaryJunctions, ChangeToWhatCostsLess) {
    struct Row {
        const char* what;
        Complex<double> complex;
        std::set<Phase> taken;
        std::ptrdiff_t on_floor;
        std::size_t inside;
    };
    const std::vector<Row> rows{
        {"a phase leaves the domain boundary where its foot is short",
         narrow_foot(0.3),
         {1, 3},
         1,
         1},
        {"two sides of a steep wedge at one place leave it", wedge(0, 5), {1, 3}, 1, 1},
        {"those of a flat one split", wedge(0, 0.5), {2}, 2, 0},
        {"a short curve to the domain boundary vanishes", wedge(0.1, 1), {2}, 2, 0}};
    for (const Row& row : rows) {
        SCOPED_TRACE(row.what);
        auto complex = row.complex;
        const auto events = change(complex);
        ASSERT_EQ(events.size(), 1U);
        EXPECT_EQ(events[0].kind, EventKind::t1);
        // If phase 2 takes the area, phases 1 and 3 could lose it at the same energy: the one with
        // the smaller number does.
        EXPECT_EQ(events[0].lost, row.taken.contains(2) ? 1U : 2U);
        EXPECT_EQ((std::set<Phase>{events[0].taken[0], events[0].taken[1]}), row.taken);
        EXPECT_GT(events[0].area, 0);
        const Ends ends = ends_of(complex);
        EXPECT_EQ(on_floor(ends.on_boundary), row.on_floor);
        EXPECT_EQ(ends.inside.size(), row.inside);
        EXPECT_EQ(ends.crowded, 0U);
    }
}

TEST(BoundaryJunctions, StayWhereThatCostsLessAndWhereTheyHaveTo) {
    TopologyOptions<double> dear = changing(); // an interface between 1 and 3
    dear.energy = [](Phase one, Phase other) { return one + other == 4 ? 5.0 : 1.0; };
    TopologyOptions<double> kept = changing();
    kept.pairs = {{.one = 2, .other = 3, .rule = Topology::keep}};
    struct Row {
        const char* what;
        Complex<double> complex;
        TopologyOptions<double> options = changing();
    };
    const std::vector<Row> rows{
        {"the sides of a foot pull it open", narrow_foot(1.0)},
        {"a junction pulls away from the domain boundary", wedge(0.1, 5)},
        {"what would come instead is dear", narrow_foot(0.3), dear},
        {"the pair has to stay", narrow_foot(0.3), kept},
        {"the pair has to stay at a junction as well", wedge(0.1, 1), kept},
        {"a curve in a corner", from_corner(1.0)},
        {"a steep one", from_corner(2.0)},
        {"a flat one", from_corner(0.4)},
        {"a curve stands upright on the domain boundary that ends in a reentrant corner",
         grid({-3, -2, -1, -0.1, 0, 1, 2, 3, 4}, {-3, -2, -1, 0, 1, 2, 3}, [](const P& p) {
             return p.x() < 0 && p.y() < 0 ? nothing : (p.x() < -0.1 ? 1U : 2U);
         })}};
    for (const Row& row : rows) {
        auto complex = row.complex;
        EXPECT_TRUE(change(complex, row.options).empty()) << row.what;
        EXPECT_EQ(ends_of(complex).on_boundary.size(), ends_of(row.complex).on_boundary.size())
            << row.what;
    }
}

TEST(BoundaryJunctions, FourSectorsAtOnePlaceComeApart) {
    auto complex = grid({-3, -2, -1, 0, 1, 2, 3}, {0, 1, 2, 3}, [](const P& p) {
        return p.y() < std::abs(p.x()) ? (p.x() > 0 ? 1U : 4U) : (p.x() > 0 ? 2U : 3U);
    });
    ASSERT_EQ(ends_of(complex).crowded, 1U);
    const auto events = change(complex);
    EXPECT_GE(events.size(), 2U);
    EXPECT_EQ(ends_of(complex).crowded, 0U);
}

// --- corners of the domain ----------------------------------------------------------------------

TEST(BoundaryJunctions, AnEndThatReachesACornerGoesOnAlongTheOtherBoundary) {
    std::vector<double> ys;
    for (int y = 0; y <= 14; ++y) {
        ys.push_back(y);
    }
    auto complex = grid({0, 0.1, 1.1, 2.1}, ys, [](const P& p) { return p.x() < 0.1 ? 1U : 2U; });
    const auto events = change(complex);
    ASSERT_EQ(events.size(), 2U); // at both ends
    for (const Event& event : events) {
        EXPECT_EQ(event.kind, EventKind::t1);
        EXPECT_EQ(event.lost, 1U);
        EXPECT_EQ(event.taken, (std::array<Phase, 2>{2, 2}));
    }
    EXPECT_EQ(phase_at_corner(complex, P(0, 0)), 2U);
    EXPECT_EQ(phase_at_corner(complex, P(0, 14)), 2U);
    const Ends ends = ends_of(complex);
    ASSERT_EQ(ends.on_boundary.size(), 2U);
    for (const P& end : ends.on_boundary) {
        EXPECT_EQ(end.x(), 0);
        EXPECT_LT(std::min(end.y(), 14 - end.y()), 0.3);
        EXPECT_GT(std::min(end.y(), 14 - end.y()), 0.1);
    }
}

TEST(BoundaryJunctions, ACurveInACornerGoesOnWhereItLiesAlongAWall) {
    for (const auto& [slope, lost] : {std::pair{5.0, 1U}, std::pair{0.2, 2U}}) {
        auto complex = from_corner(slope);
        const auto events = change(complex);
        ASSERT_EQ(events.size(), 1U);
        EXPECT_EQ(events[0].lost, lost);
        EXPECT_EQ(phase_at_corner(complex, P(0, 0)), 3 - lost);
    }
}

// --- what other changes leave behind ------------------------------------------------------------

TEST(BoundaryJunctions, WhereAFilmOpensAtAJunctionTheVertexComesApartAtOnce) {
    std::vector<double> xs;
    for (int x = -8; x <= 8; ++x) {
        xs.push_back(x);
    }
    auto complex = grid(xs, {-2, -1, 0, 0.2, 1.2, 2.2}, [](const P& p) {
        return p.y() < 0 ? 1U : (p.y() < 0.2 ? film : (p.x() < 0 ? 2U : 3U));
    });
    TopologyOptions<double> options = changing();
    options.opening = Opening::thin;
    EXPECT_FALSE(change(complex, options).empty());
    EXPECT_EQ(ends_of(complex).crowded, 0U);
}

// --- inside -------------------------------------------------------------------------------------

// Sectors 1 (right), 2 (above), 3 (left) and 4 (below) about the origin; 1 and 3 are of 80 degrees.
Complex<double> four_sectors() {
    const double scale = std::tan(40 * std::numbers::pi / 180);
    return grid({-3, -2, -1, 0, 1, 2, 3},
                {-3 * scale, -2 * scale, -scale, 0, scale, 2 * scale, 3 * scale}, [=](const P& p) {
                    return std::abs(p.y()) < std::abs(p.x()) * scale ? (p.x() > 0 ? 1U : 3U)
                                                                     : (p.y() > 0 ? 2U : 4U);
                });
}

TEST(Junctions, TheEnergyDecidesWhichSectorsPart) {
    for (const bool is_dear : {false, true}) {
        auto complex = four_sectors();
        TopologyOptions<double> options = changing();
        if (is_dear) { // an interface between 2 and 4
            options.energy = [](Phase one, Phase other) {
                return one + other == 6 && one != other ? 5.0 : 1.0;
            };
        }
        const auto events = change(complex, options);
        ASSERT_GE(events.size(), 1U);
        const std::set<Phase> taken{events[0].taken[0], events[0].taken[1]};
        EXPECT_EQ(taken, is_dear ? (std::set<Phase>{1, 3}) : (std::set<Phase>{2, 4}));
        EXPECT_EQ(ends_of(complex).crowded, 0U);
    }
}

TEST(Junctions, ANegativeEnergyIsRefused) {
    auto complex = four_sectors();
    TopologyOptions<double> options = changing();
    options.energy = [](Phase, Phase) { return -1.0; };
    EXPECT_THROW((void)change(complex, options), InputError);
    EXPECT_EQ(validate(complex).problem, "");
}

TEST(Pieces, GoToThePhaseThatTheyBorderOnMost) {
    for (const Phase largest : {Phase{2}, Phase{3}}) {
        auto complex = grid({-2, -1, 0, 1, 2}, {-2, -1, 0, 1, 2}, [largest](const P& p) {
            const bool is_piece = std::abs(p.x() + 0.5) < 0.5 && std::abs(p.y() + 0.5) < 0.5;
            return is_piece ? 1U : (p.x() < 0 ? largest : 5 - largest);
        });
        TopologyOptions<double> options = changing();
        options.min_area = 1.01; // the piece has 1
        const auto events = change(complex, options);
        ASSERT_EQ(events.size(), 1U);
        EXPECT_EQ(events[0].kind, EventKind::remove);
        EXPECT_NEAR(events[0].area, 1, 1e-12);
        EXPECT_EQ(phase_at_corner(complex, P(-0.5, -0.5)), largest);
    }
}

// Fronts that come from all sides at one speed reach a square's middle together: each takes the
// quarter at its side.
TEST(Pieces, AreSharedAsTheFrontsAroundThemReachThem) {
    auto complex = grid({-2, -1, 0, 1, 2}, {-2, -1, 0, 1, 2}, [](const P& p) {
        const bool is_piece = std::abs(p.x() + 0.5) < 0.5 && std::abs(p.y() + 0.5) < 0.5;
        return is_piece ? exterior_phase : Phase(p.x() < 0 ? 2 : 3);
    });
    TopologyOptions<double> options = changing();
    options.min_area = 1.01; // the piece has 1
    const auto events = change(complex, options);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::fill);
    EXPECT_NEAR(events[0].area, 1, 1e-12);
    EXPECT_EQ(events[0].taken[0], 2U); // it borders on it most
    EXPECT_NEAR(phase_area(complex, 2), 8 - 1 + 0.75, 1e-3);
    EXPECT_NEAR(phase_area(complex, 3), 8 + 0.25, 1e-3);
}

// On a side that was smooth at the start and turns more later on, as in a corner.
TEST(Pieces, AreSharedOnACurvedSideAndInACorner) {
    const std::vector<P> points{{-1, 0}, {0, -0.18}, {1, 0}, {0, 1}, {-2, 0.5}, {2, 0.5}, {0, 2}};
    const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 3}, {1, 2, 3}, {0, 3, 4},
                                                              {4, 3, 6}, {2, 5, 3}, {5, 6, 3}};
    const std::vector<Phase> phases{0, 0, 1, 1, 2, 2};
    for (const bool is_corner : {false, true}) {
        auto complex = make_complex<double>(points, triangles, phases);
        complex.set_boundary_feature(Vertex{1}, is_corner); // a turn of 20 degrees
        const double larger = std::max(phase_area(complex, 1), phase_area(complex, 2));
        TopologyOptions<double> options = changing();
        options.min_area = 1.2; // the piece has 1.18
        const auto events = change(complex, options);
        ASSERT_EQ(events.size(), 1U);
        EXPECT_EQ(events[0].kind, EventKind::fill);
        const double now = std::max(phase_area(complex, 1), phase_area(complex, 2));
        EXPECT_NEAR(now - larger, 0.59, 1e-3);
    }
}

// The nearest vertex of the other front is in a notch, and is no front itself: the fronts meet
// where the one is, on the edge of the other.
TEST(Fronts, MeetOnTheEdgeBesideANotch) {
    const std::vector<P> points{{0, 0},   {2, 0}, {0.2, 1e-4}, {-0.4, 1.5},
                                {0, 1.5}, {2, 1}, {0.5, -2},   {-2, 0}};
    enum : std::uint32_t { notch, right, tip, left, top, high, low, far };
    const std::vector<std::array<std::uint32_t, 3>> triangles{
        {notch, right, tip}, {right, high, tip},  {notch, tip, left}, {left, tip, top},
        {tip, high, top},    {low, right, notch}, {far, low, notch},  {far, notch, left}};
    auto complex =
        make_complex<double>(points, triangles, std::vector<Phase>{0, 0, 0, 0, 2, 1, 1, 1});
    complex.vertices[tip].flags |= vertex_contact;
    const auto events = change(complex);
    ASSERT_GE(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::meet);
    EXPECT_NEAR(events[0].x, 0.2, 1e-3);
    EXPECT_NEAR(events[0].y, 0, 1e-4);
}

} // namespace
} // namespace dsc::junctions_test
