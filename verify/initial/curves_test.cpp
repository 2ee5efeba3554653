// SPDX-License-Identifier: MIT
// The initial complex of a network of curves: every curve keeps its points and the phases on its
// two sides, and triangles are as good as the angles between the curves allow.
#include "replay/mesh_hash.h"
#include "shapes/shapes.h"
#include "shapes/voronoi.h"
#include "shapes/voronoi_diagram.h"
#include "support/curve_testing.h"

#include <numbers>
#include <ostream>

namespace dsc::curves_test {
namespace {

using test::CurveScenery;

using std::numbers::pi;

struct Case {
    std::string name;
    CurveScenery scenery;
    std::map<Phase, double> areas; // exact, or empty
    double smallest_angle;         // bound that the angles of the input allow
};

std::vector<Point<double>> arc(const Point<double>& centre, double radius, double from, double to,
                               double h) {
    const int n = static_cast<int>(std::ceil(radius * std::abs(to - from) / h));
    std::vector<Point<double>> points;
    for (int i = 0; i <= n; ++i) {
        const double angle = from + (to - from) * i / n;
        points.emplace_back(centre.x() + radius * std::cos(angle),
                            centre.y() + radius * std::sin(angle));
    }
    return points;
}

// Two arcs between the same two ends, and a straight line from each end to a side of the domain.
Case lens(double h) {
    const double radius = 0.2;
    auto upper = arc({0.5, 0.5}, radius, 0, pi, h);
    upper.front() = {0.7, 0.5};
    upper.back() = {0.3, 0.5};
    auto lower = upper;
    for (Point<double>& p : lower) {
        p.y() = 1 - p.y();
    }
    const auto n = static_cast<double>(2 * (upper.size() - 1));
    const double disc = 0.5 * n * radius * radius * std::sin(2 * pi / n);
    return {"lens",
            {{{upper, 3, 1},
              {lower, 2, 3},
              {{{0, 0.5}, {0.3, 0.5}}, 1, 2},
              {{{0.7, 0.5}, {1, 0.5}}, 1, 2}},
             h},
            {{1, 0.5 - disc / 2}, {2, 0.5 - disc / 2}, {3, disc}},
            25};
}

// Curves from the centre at +-40 degrees to the horizontal.
Case four_sectors(double h) {
    const Point<double> centre(0.5, 0.5);
    const double t = 0.5 * std::tan(40 * pi / 180);
    return {"four_sectors",
            {{{{centre, {1, 0.5 + t}}, 2, 1},
              {{centre, {0, 0.5 + t}}, 3, 2},
              {{centre, {0, 0.5 - t}}, 4, 3},
              {{centre, {1, 0.5 - t}}, 1, 4}},
             h},
            {{1, t / 2}, {2, 0.5 - t / 2}, {3, t / 2}, {4, 0.5 - t / 2}},
            29};
}

std::vector<Case> cases() {
    const double h = 0.05;
    const Curve floor{{{0, 0.1}, {0.2, 0.1}, {0.3, 0.08}, {0.5, 0.1}, {1, 0.12}}, 0, 1};
    return {
        {"half_planes", {{{{{0, 0.437}, {1, 0.437}}, 2, 1}}, h}, {{1, 0.437}, {2, 0.563}}, 29},
        {"slanted", {{{{{0, 0.3}, {1, 0.71}}, 2, 1}}, 0.02}, {{1, 0.505}, {2, 0.495}}, 29},
        {"from_corner_to_corner", {{{{{0, 0}, {1, 1}}, 0, 5}}, h}, {{0, 0.5}, {5, 0.5}}, 29},
        {"one_phase_twice",
         {{{{{0, 0.3}, {1, 0.3}}, 1, 7}, {{{0, 0.6}, {1, 0.6}}, 7, 1}}, h},
         {{1, 0.3}, {7, 0.7}},
         29},
        {"t_at_the_wall",
         {{{{{0, 0.4}, {0.5, 0.4}}, 1, 0},
           {{{0.5, 0.4}, {1, 0.4}}, 1, 2},
           {{{0.5, 0.4}, {0.5, 0}}, 2, 0}},
          h},
         {{0, 0.2}, {1, 0.6}, {2, 0.2}},
         29},
        {"two_on_one_point_of_the_wall",
         {{{{{0.5, 0}, {0.2, 1}}, 1, 2}, {{{0.5, 0}, {0.7, 1}}, 2, 3}}, h},
         {{1, 0.35}, {2, 0.25}, {3, 0.4}},
         23},
        {"small_angle_at_the_wall", {{{{{0, 0.1}, {1, 0.3}}, 1, 0}}, h}, {{0, 0.2}, {1, 0.8}}, 29},
        {"near_a_corner", {{{{{0.02, 0}, {0, 0.02}}, 1, 0}}, h}, {{0, 0.9998}, {1, 0.0002}}, 25},
        {"pool", {{floor}, 0.03}, {}, 29},
        {"in_a_strip_at_the_wall",
         {{{{{0.01, 0}, {0.01, 1}}, 1, 0}}, h},
         {{0, 0.99}, {1, 0.01}},
         19},
        four_sectors(h),
        four_sectors(0.013),
        lens(h),
        lens(0.02),
    };
}

void PrintTo(const Case& test, std::ostream* out) { *out << test.name; }

class InitialCurves : public ::testing::TestWithParam<Case> {};

TEST_P(InitialCurves, ComeOutAsTheyWentIn) {
    const Case& test = GetParam();
    const auto complex = test::complex_of<double>(test.scenery);
    test::expect_sound(complex, test.scenery);
    const double angle = test::smallest_angle(complex);
    RecordProperty("smallest_angle_deg", std::to_string(angle));
    EXPECT_GE(angle, test.smallest_angle);
    if (!test.areas.empty()) {
        const auto areas = test::areas_by_phase(complex);
        ASSERT_EQ(areas.size(), test.areas.size());
        for (const auto& [phase, area] : test.areas) {
            EXPECT_NEAR(areas.at(phase), area, 1e-14) << "phase " << phase;
        }
    }
}

TEST_P(InitialCurves, ComeOutAsTheyWentInAsFloat) {
    const Case& test = GetParam();
    const auto complex = test::complex_of<float>(test.scenery);
    test::expect_sound(complex, test.scenery);
    EXPECT_GE(test::smallest_angle(complex), 0.97 * test.smallest_angle);
    const auto areas = test::areas_by_phase(complex);
    for (const auto& [phase, area] : test.areas) {
        EXPECT_NEAR(areas.at(phase), area, 2e-7) << "phase " << phase;
    }
}

// The direction of a curve does not matter: reversed, with left and right exchanged, it is the same
// curve.
TEST_P(InitialCurves, MayRunEitherWay) {
    CurveScenery backwards = GetParam().scenery;
    for (Curve& curve : backwards.curves) {
        std::reverse(curve.points.begin(), curve.points.end());
        std::swap(curve.left, curve.right);
    }
    const auto complex = test::complex_of<double>(backwards);
    test::expect_sound(complex, backwards);
    EXPECT_GE(test::smallest_angle(complex), 0.9 * GetParam().smallest_angle);
}

INSTANTIATE_TEST_SUITE_P(Networks, InitialCurves, ::testing::ValuesIn(cases()),
                         [](const auto& test) {
                             return test.param.name + "_" +
                                    std::to_string(std::lround(1 / test.param.scenery.edge_length));
                         });

// Wherever a curve ends on a side of the domain, vertices of that side are spaced to fit.
TEST(InitialCurvesSizes, CurvesToTheSidesAnywhereGetGoodTriangles) {
    for (int i = 1; i < 40; ++i) {
        const double from = 0.1 + 0.02 * i;
        const double to = 0.1 + 0.8 * std::fmod(0.618 * i, 1.0);
        const bool upwards = i % 2 == 0;
        const Curve curve{upwards ? std::vector<Point<double>>{{from, 0}, {to, 1}}
                                  : std::vector<Point<double>>{{0, from}, {1, to}},
                          1, 0};
        const auto complex = test::complex_of<double>({{curve}, 0.05 - 0.0007 * i});
        EXPECT_GE(test::smallest_angle(complex), 29) << i;
    }
}

// Hundreds of curves and junctions, in general position.
TEST(InitialCurvesOfCells, HaveTheCellsAsPhases) {
    struct Grains {
        std::size_t count;
        int rounds; // of relaxation
        std::uint64_t seed;
        double h;
    };
    for (const Grains& g : {Grains{100, 0, 1, 0.02}, Grains{100, 3, 2, 0.02},
                            Grains{1000, 0, 2, 0.006}, Grains{1000, 3, 1, 0.006}}) {
        const auto random = dsc::scenes::random_sites({}, g.count, g.seed);
        const auto sites = dsc::scenes::relaxed_sites({}, random, g.rounds);
        const CurveScenery scenery{dsc::scenes::voronoi_curves({}, sites, 0.3 * g.h), g.h};
        const auto complex = test::complex_of<double>(scenery);
        test::expect_sound(complex, scenery);
        const auto diagram =
            dsc::scenes::without_short_edges(dsc::scenes::voronoi_diagram({}, sites), 0.3 * g.h);
        const auto areas = test::areas_by_phase(complex);
        ASSERT_EQ(areas.size(), sites.size());
        for (std::size_t i = 0; i < sites.size(); ++i) {
            EXPECT_NEAR(areas.at(static_cast<Phase>(i + 1)),
                        dsc::scenes::signed_area(diagram.corners_of(diagram.cells[i])), 1e-15);
        }
    }
}

TEST(InitialCurvesAndShapes, AClosedCurveIsTheInterfaceOfItsShape) {
    const double h = 0.03;
    const auto circle = dsc::scenes::circle({0.5, 0.5}, 0.25, h);
    Curve closed{circle, 1, 0};
    closed.points.push_back(circle.front());
    const auto of_shape = dsc::initial_complex<double>({}, {{circle, 1}}, {.edge_length = h});
    const auto of_curve =
        dsc::initial_complex<double>({}, std::vector<Curve>{closed}, {.edge_length = h});
    EXPECT_EQ(dsc::mesh_hash(of_curve), dsc::mesh_hash(of_shape));
}

} // namespace

} // namespace dsc::curves_test
