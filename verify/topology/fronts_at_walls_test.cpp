// SPDX-License-Identifier: MIT
// Single changes on meshes made for them: the last film at the domain boundary is divided, a vertex
// at its curve's end or a junction lands, a short interface edge goes.
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "topology/fronts/division.h"
#include "topology/junctions/mending.h"
#include "topology/landing/landing.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <vector>

namespace dsc::fronts_at_walls_test {
namespace {

using P = Point<double>;

constexpr double h = 0.03;

// What changes of topology work on, outside of a simulation.
class FrontsAtWalls : public ::testing::Test {
protected:
    TopologyWork<double> work_on(Complex<double>& complex) {
        begin_notes(complex);
        return {.complex = complex,
                .options = options_,
                .edge_length = h,
                .time = 0,
                .events = events_};
    }
    static bool is_on_sheet(const Complex<double>& complex, Vertex v) {
        return find_corner(complex, v, [&](Corner c) { return is_sheet(complex, prev(c)); }) !=
               no_id;
    }
    // The vertex of the interface that is nearest to the place.
    static Vertex nearest(const Complex<double>& complex, const P& place) {
        Vertex found;
        for (const Vertex v : vertices(complex)) {
            if (is_on_sheet(complex, v) &&
                (!found.is_valid() ||
                 (complex.position(v) - place).norm() < (complex.position(found) - place).norm())) {
                found = v;
            }
        }
        return found;
    }
    static void move(Complex<double>& complex, Vertex v, const P& to) {
        rewire::move(complex, complex.journal, v.id, to.x(), to.y(), MoveReason::smoothing);
    }

    TopologyOptions<double> options_{.rule = Topology::change};
    std::vector<Event> events_;
};

// A triangle between two fronts and a wall: the seam leaves the vertex between the fronts on their
// bisector, and so divides the side on the wall as the lengths of the fronts.
TEST_F(FrontsAtWalls, ALastFilmAtAWallIsDividedOnTheBisectorOfItsFronts) {
    const P a(0.4, 0);
    const P b(0.6, 0);
    for (const P& c : {P(0.5, 0.1), P(0.46, 0.12), P(0.41, 0.15), P(0.56, 0.05)}) {
        SCOPED_TRACE(testing::Message() << c.transpose());
        const std::vector<Curve> curves{{{a, c}, 1, 0}, {{c, b}, 2, 0}, {{c, {c.x(), 1}}, 1, 2}};
        auto complex = initial_complex<double>({}, curves, {.edge_length = h});
        TopologyWork<double> work = work_on(complex);
        std::vector<Triangle> film;
        for (const Triangle t : triangles(complex)) {
            if (complex.phase(t) == 0) {
                film.push_back(t);
            }
        }
        std::array<double, 3> areas{};
        const std::array<Phase, 2> takers{1, 2};
        for (const Share& share : divide_by_arrival<double>(work, film, takers)) {
            areas.at(share.to) += doubled_area(complex, share.triangle) / 2;
            give(work, share.triangle, share.to);
        }
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_EQ(phase_area(complex, 0), 0);
        const double ratio = (c - a).norm() / ((c - a).norm() + (c - b).norm());
        const double whole = c.y() * (b - a).norm() / 2;
        EXPECT_NEAR(areas[1], ratio * whole, 0.02 * h * c.y());
        EXPECT_NEAR(areas[2], (1 - ratio) * whole, 0.02 * h * c.y());
    }
}

// The direction of a shorter edge would be little more than rounding.
TEST_F(FrontsAtWalls, AVertexAtItsCurvesEndLandsAndNoOther) {
    const std::vector<Curve> curves{{{{0.5, 0}, {0.5, 1}}, 1, 0}};
    for (const double height : {0.03 * h, 0.08 * h}) {
        SCOPED_TRACE(height / h);
        auto complex = initial_complex<double>({}, curves, {.edge_length = h});
        const Vertex v = nearest(complex, {0.5, h});
        move(complex, v, {0.5, height});
        Candidate candidate{};
        candidate.vertex = v.id;
        const std::array candidates{candidate};
        TopologyWork<double> work = work_on(complex);
        land_vertices<double>(work, candidates);
        EXPECT_EQ(complex.is_alive(v), height > 0.05 * h);
        EXPECT_TRUE(events_.empty());
        EXPECT_EQ(validate(complex).problem, "");
    }
}

// On each side of the domain, unless the application refuses the contact.
TEST_F(FrontsAtWalls, AJunctionThatHasRunThereLands) {
    const auto turned = [](P p, int quarters) {
        for (int i = 0; i < quarters; ++i) {
            p = P(1 - p.y(), p.x());
        }
        return p;
    };
    for (int quarters = 0; quarters < 4; ++quarters) {
        for (const bool may_land : {true, false}) {
            SCOPED_TRACE(testing::Message() << quarters << " quarters, " << may_land);
            const auto at = [&](double x, double y) { return turned({x, y}, quarters); };
            const P seam = at(0.5, h);
            auto complex = initial_complex<double>({},
                                                   std::vector<Curve>{{{at(0.4, 0), seam}, 1, 0},
                                                                      {{seam, at(0.6, 0)}, 2, 0},
                                                                      {{seam, at(0.5, 1)}, 1, 2}},
                                                   {.edge_length = h});
            const Vertex v = nearest(complex, seam);
            move(complex, v, at(0.5, 0.03 * h));
            ASSERT_EQ(validate(complex).problem, "");
            Candidate candidate{};
            candidate.vertex = v.id;
            const std::array candidates{candidate};
            options_.may_change = [&](const Contact&) { return may_land; };
            TopologyWork<double> work = work_on(complex);
            land_junctions<double>(work, candidates);
            EXPECT_EQ(validate(complex).problem, "");
            const Vertex end = nearest(complex, at(0.5, 0));
            EXPECT_EQ(is_on_boundary(complex, end), may_land);
            EXPECT_LT((complex.position(end) - at(0.5, 0)).norm(), 0.05 * h);
        }
    }
}

TEST_F(FrontsAtWalls, AShortInterfaceEdgeGoesAndLeavesTheAreas) {
    std::vector<P> circle;
    constexpr int n = 60;
    for (int i = 0; i <= n; ++i) {
        const double angle = 2 * std::numbers::pi * (i % n) / n;
        circle.push_back(P(0.5, 0.5) + 0.25 * P(std::cos(angle), std::sin(angle)));
    }
    auto complex =
        initial_complex<double>({}, std::vector<Curve>{{circle, 1, 0}}, {.edge_length = h});
    const double area = phase_area(complex, 1);
    const Vertex kept = nearest(complex, circle[0]);
    const Vertex gone = nearest(complex, circle[1]);
    const P before = complex.position(gone);
    move(complex, gone, complex.position(kept) + 0.05 * (before - complex.position(kept)));
    const double moved = phase_area(complex, 1);
    EXPECT_NE(moved, area);
    TopologyWork<double> work = work_on(complex);
    collapse_short_sheets(work, kept);
    EXPECT_TRUE(complex.is_alive(kept));
    EXPECT_FALSE(complex.is_alive(gone));
    EXPECT_NEAR(phase_area(complex, 1), moved, 1e-14);
    EXPECT_EQ(validate(complex).problem, "");
}

} // namespace
} // namespace dsc::fronts_at_walls_test
