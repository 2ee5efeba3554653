// SPDX-License-Identifier: MIT
// What curvature flow refuses; arcs whose chord is a diameter; fractions of a move.
#include "dsc/base/error.h"
#include "dsc/complex/gather.h"
#include "dsc/motion/curvature_flow.h"
#include "dsc/motion/interpolation.h"
#include "dsc/motion/movement.h"

#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dsc::limits_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

void expect_refused(const CurvatureFlowOptions& options, const std::string& words) {
    try {
        (void)curvature_flow<double>(options);
        ADD_FAILURE() << "no error; expected: " << words;
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(CurvatureFlowOptions, ForcesAreFiniteAndOfOneSign) {
    for (const double bad : {-1.0, infinity, not_a_number}) {
        expect_refused({.tension = bad}, "tension of all pairs");
        expect_refused({.mobility = bad}, "mobility of all pairs");
        expect_refused({.pairs = {{.one = 1, .other = 2, .tension = bad}}}, "tension of phases");
    }
    expect_refused({.mobility = 0}, "mobility of all pairs");
    EXPECT_NO_THROW((void)curvature_flow<double>({.tension = 0}));
}

TEST(CurvatureFlowOptions, PairsAndPhasesAreOfTheDomainAndNamedOnce) {
    expect_refused({.pairs = {{.one = 1, .other = 1}}}, "no interface between");
    expect_refused({.pairs = {{.one = border_phase, .other = 1}}}, "no interface between");
    expect_refused({.pairs = {{.one = 1, .other = border_phase}}}, "no interface between");
    expect_refused({.pairs = {{.one = 1, .other = 2}, {.one = 2, .other = 1}}}, "given twice");
    expect_refused({.walls = {{.phase = border_phase, .energy = 1}}}, "energy of the wall");
    expect_refused({.walls = {{.phase = 1, .energy = infinity}}}, "energy of the wall");
    expect_refused({.walls = {{.phase = 1}, {.phase = 1}}}, "two energies");
    EXPECT_NO_THROW((void)curvature_flow<double>({.walls = {{.phase = 1, .energy = -1}}}));
}

TEST(CurvatureFlowOptions, KeptAreasArePositive) {
    for (const double bad : {0.0, -1.0, infinity, not_a_number}) {
        expect_refused({.kept_areas = {{.phase = 1, .area = bad}}}, "not an area");
    }
    expect_refused({.kept_areas = {{.phase = exterior_phase, .area = 1}}}, "cannot be kept");
    expect_refused({.kept_areas = {{.phase = 1, .area = 1}, {.phase = 1, .area = 2}}},
                   "kept twice");
    EXPECT_NO_THROW((void)curvature_flow<double>({.kept_areas = {{.phase = 1, .area = 1}}}));
}

// A right angle over the chord: the arc is a half circle, and its sine 1 apart from rounding.
TEST(ArcInsertion, OfAHalfCircleIsHalfAChordAway) {
    for (int i = 1; i < 2000; ++i) {
        const double turn = 0.01 * i;
        const double at = 0.1 + 0.0014 * i;
        const auto on_circle = [&](double angle) {
            return Point<double>(0.3 * std::cos(angle + turn), 0.3 * std::sin(angle + turn));
        };
        for (const double side : {1.0, -1.0}) {
            CurveNeighbours<double> n;
            n.p0 = on_circle(side * at);
            n.p1 = on_circle(0);
            n.p2 = on_circle(3.14159265358979323846);
            n.has_first = true;
            const Point<double> p = insertion_point(Insertion::arc, n);
            ASSERT_NEAR(p.norm(), 0.3, 1e-6) << i << ' ' << side;
        }
    }
}

TEST(MoveLimit, IsAShareOfTheWay) {
    const auto complex = test::hexagon<double>();
    Ring<double> ring;
    ASSERT_TRUE(gather(complex, Region{}, 0, ring));
    EXPECT_EQ(move_limit(ring, 0.01, 0.0), 1);
    EXPECT_EQ(move_limit(ring, 0.0, 0.0), 1);
    EXPECT_GT(move_limit(ring, 3.0, 0.0), 0);
    EXPECT_LT(move_limit(ring, 3.0, 0.0), 0.34);
}

} // namespace
} // namespace dsc::limits_test
