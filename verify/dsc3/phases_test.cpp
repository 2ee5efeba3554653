// SPDX-License-Identifier: MIT
// Several phases that meet: a ball that one, two or three planes through its centre divide. Sheets
// meet in junction curves (circles and diameters), and those in points.
#include "dsc3/space_testing.h"
#include "support/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace dsc3::test::phases_test {
namespace {

constexpr double h = 1.0 / 20;
constexpr double radius = 0.2;
const Point centre(0.35, 0.36, 0.37);
// Planes at right angles, tilted away from the lattice.
const Eigen::Matrix3d planes =
    (Eigen::AngleAxisd(0.2, Point::UnitX()) * Eigen::AngleAxisd(0.3, Point::UnitY()))
        .toRotationMatrix();

Distance plane(int k) {
    return [k](const Point& p) { return (p - centre).dot(planes.col(k)); };
}

Complex divided_ball(int cuts) {
    const std::vector<Shape> shapes{{ball(centre, radius), 1},
                                    {plane(0), 1, {{1, 2}}},
                                    {plane(1), 1, {{1, 3}, {2, 4}}},
                                    {plane(2), 1, {{1, 5}, {2, 6}, {3, 7}, {4, 8}}}};
    return initial_complex({}, std::span(shapes).first(std::size_t(cuts) + 1), {.edge_length = h});
}

// How far the vertices of junction curves are from the two nearest of the surfaces, at most; points
// from the three nearest.
double off_curves(const Complex& complex, const Point& moved, int cuts) {
    double most = 0;
    for_each_interface_star(complex, [&](std::uint32_t v, const InterfaceStar&, Stratum stratum) {
        const Point p = complex.at(v) - moved;
        std::vector<double> d{std::abs((p - centre).norm() - radius)};
        for (int k = 0; k < cuts; ++k) {
            d.push_back(std::abs(plane(k)(p)));
        }
        std::sort(d.begin(), d.end());
        most = std::max(most, stratum == Stratum::sheet   ? 0
                              : stratum == Stratum::curve ? d[1]
                                                          : d[2]);
    });
    return most;
}

constexpr std::array<std::uint32_t, 4> points_of{0, 0, 2, 7};

TEST(Phases3, DividedBallsBeginWithExactCurves) {
    for (const int cuts : {1, 2, 3}) {
        const Complex complex = divided_ball(cuts);
        const ValidationReport report = validate(complex);
        ASSERT_TRUE(report.ok()) << report.problem;
        ASSERT_EQ(report.surfaces.size(), (1U << unsigned(cuts)) + 1);
        const double part = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3) / (1 << cuts);
        for (std::size_t i = 1; i < report.surfaces.size(); ++i) {
            EXPECT_EQ(report.surfaces[i].euler_characteristic, 2);
            EXPECT_NEAR(phase_volume(complex, report.surfaces[i].phase) / part, 1, 0.04);
        }
        const StrataCounts strata = count_strata(complex);
        EXPECT_GT(strata.curve, 20U * unsigned(cuts));
        EXPECT_EQ(strata.point, points_of[std::size_t(cuts)]);
        EXPECT_LT(off_curves(complex, Point::Zero(), cuts), 1e-10);
        EXPECT_GT(mesh_quality(complex).min_dihedral, 9) << cuts << " cuts";
    }
}

// In this start a cut gives the id of a tet that was looked at already to one that is not cut yet.
TEST(Phases3, ACutMissesNoEdge) {
    if (dsc::test::are_asked_for("few")) {
        GTEST_SKIP() << "a large mesh";
    }
    const Point middle(0.35, 0.35, 0.35);
    const Point normal = Point(1, 0.13, 0.07).normalized();
    const Distance across = [&](const Point& p) { return (p - middle).dot(normal); };
    const Complex complex = initial_complex({}, {{ball(middle, 0.15), 1}, {across, 1, {{1, 2}}}},
                                            {.edge_length = 1.0 / 64});
    double most = 0;
    for_each_interface_star(complex, [&](std::uint32_t v, const InterfaceStar&, Stratum stratum) {
        most = std::max(most, stratum == Stratum::curve ? std::abs(across(complex.at(v))) : 0);
    });
    EXPECT_LT(most, 1e-10);
}

// A core that covers the middle of a dividing plane: the circle in which they meet is a curve, and
// nothing of the plane is left within.
TEST(Phases3, AShapeCoversAPartOfAnEarlierOne) {
    Complex complex = initial_complex({},
                                      {{ball(centre, radius), 1},
                                       {plane(0), 1, {{1, 2}}},
                                       {ball(centre, 0.5 * radius), 1, {{1, 3}, {2, 3}}}},
                                      {.edge_length = 0.6 * h});
    const ValidationReport report = validate(complex);
    ASSERT_TRUE(report.ok()) << report.problem;
    ASSERT_EQ(report.surfaces.size(), 4U);
    EXPECT_EQ(report.surfaces[3].euler_characteristic, 2);
    EXPECT_EQ(count_strata(complex).point, 0U);
    EXPECT_NEAR(phase_volume(complex, 3), 4.0 / 3 * std::numbers::pi * std::pow(0.5 * radius, 3),
                2e-4);
    Simulation simulation(complex, {.edge_length = 0.6 * h});
    const int steps = dsc::test::are_asked_for("few") ? 1 : 3;
    for (int k = 0; k < steps; ++k) {
        EXPECT_EQ(simulation.step(swirl, 0, 0.02).unreached, 0U);
        ASSERT_TRUE(validate(complex).ok()) << validate(complex).problem;
    }
    EXPECT_THROW((void)initial_complex({}, {{ball(centre, radius), 1}, {plane(0), 1, {{4, 2}}}},
                                       {.edge_length = h}),
                 InputError);
}

TEST(Phases3, ATranslationKeepsCurvesAndPointsExactly) {
    Complex complex = divided_ball(3);
    std::array<double, 9> before{};
    for (Phase phase = 1; phase <= 8; ++phase) {
        before[phase] = phase_volume(complex, phase);
    }
    Simulation simulation(complex, {.edge_length = h});
    const Point velocity(0.2, 0.15, 0.1);
    const int steps = dsc::test::are_asked_for("few") ? 4 : 16;
    for (int k = 0; k < steps; ++k) {
        const StepReport report =
            simulation.step([&](std::span<const Point> p, double,
                                std::span<Point> w) { std::fill_n(w.begin(), p.size(), velocity); },
                            0, 0.05);
        EXPECT_EQ(report.unreached, 0U);
        ASSERT_TRUE(validate(complex).ok()) << validate(complex).problem;
        ASSERT_EQ(count_strata(complex).point, 7U) << "step " << k;
    }
    EXPECT_LT(off_curves(complex, 0.05 * steps * velocity, 3), 1e-10);
    for (Phase phase = 1; phase <= 8; ++phase) {
        EXPECT_NEAR(phase_volume(complex, phase) / before[phase], 1, 2e-3) << "phase " << phase;
    }
    EXPECT_GT(mesh_quality(complex).min_dihedral, 5);
}

// The flow stretches curves and brings points together; strata survive it, and threads change
// nothing.
TEST(Phases3, StrataSurviveASwirl) {
    const int steps = dsc::test::are_asked_for("few") ? 3 : 8;
    std::array<std::uint64_t, 2> hashes{};
    for (const std::uint32_t threads : {1U, 3U}) {
        Complex complex = divided_ball(3);
        Simulation simulation(complex, {.edge_length = h}, Parallel{.threads = threads});
        OperationCounts done;
        for (int k = 0; k < steps; ++k) {
            const StepReport report = simulation.step(swirl, 0, 0.04);
            EXPECT_EQ(report.unreached, 0U);
            done += report.operations;
            const ValidationReport valid = validate(complex);
            ASSERT_TRUE(valid.ok()) << valid.problem;
            for (const PhaseSurface& surface : valid.surfaces) {
                ASSERT_EQ(surface.euler_characteristic, surface.phase == 0 ? 4 : 2) << "step " << k;
            }
            ASSERT_EQ(count_strata(complex).point, 7U) << "step " << k;
        }
        EXPECT_GT(done.interface_splits, 6U * unsigned(steps));
        hashes[threads / 2] = mesh_hash(complex);
    }
    EXPECT_EQ(hashes[0], hashes[1]);
}

// Curves that leave a point close like a zip: chords of one cut off vertices of another.
TEST(Phases3, CurvesThatCloseLikeAZipArrive) {
    if (dsc::test::are_asked_for("few")) {
        GTEST_SKIP() << "a large mesh";
    }
    constexpr double fine = 1.0 / 32;
    const Point middle(0.35, 0.35, 0.35);
    const auto across = [&](int k) { return [=](const Point& p) { return p[k] - middle[k]; }; };
    const std::vector<Shape> shapes{{ball(middle, 0.15), 1},
                                    {across(0), 1, {{1, 2}}},
                                    {across(1), 1, {{1, 3}, {2, 4}}},
                                    {across(2), 1, {{1, 5}, {2, 6}, {3, 7}, {4, 8}}}};
    Complex complex = initial_complex({}, shapes, {.edge_length = fine});
    Simulation simulation(complex, {.edge_length = fine});
    std::uint64_t unreached = 0;
    for (int k = 0; k < 25; ++k) {
        unreached += simulation.step(swirl, 0, fine).unreached;
    }
    EXPECT_EQ(unreached, 0U);
    const ValidationReport report = validate(complex);
    EXPECT_TRUE(report.ok()) << report.problem;
    EXPECT_EQ(count_strata(complex).point, 7U);
}

// A vertex of a curve collapses only along its curve, a point never.
TEST(Phases3, GuardsKeepStrata) {
    Complex complex = divided_ball(2);
    Workspace work;
    std::array<std::uint32_t, 3> legal{}; // off a curve, along it, at a point
    const CollapseRules any{.floor = 1e-6, .enough = 1e-6, .min_cos = -1, .deviation = 1};
    for_each_interface_star(complex, [&](std::uint32_t v, const InterfaceStar& star,
                                         Stratum stratum) {
        for (const StarEdge& edge : star.edges) {
            const bool is_legal = edge_collapse_guard(complex, work, Vertex{v}, Vertex{edge.vertex},
                                                      any) == Verdict::legal;
            if (stratum == Stratum::point) {
                legal[2] += is_legal ? 1U : 0U;
            } else if (stratum == Stratum::curve) {
                legal[edge.is_on_curve() ? 1 : 0] += is_legal ? 1U : 0U;
            }
        }
    });
    EXPECT_EQ(legal[0], 0U);
    EXPECT_GT(legal[1], 20U);
    EXPECT_EQ(legal[2], 0U);
}

TEST(Phases3, NewVerticesLieOnCurvesAndOnSheetsBesideThem) {
    const Complex complex = divided_ball(1); // one circle
    Workspace work;
    std::array<double, 2> straight{}; // on the circle; on the sphere beside it
    std::array<double, 2> curved{};
    for_each_interface_star(
        complex, [&](std::uint32_t v, const InterfaceStar& star, Stratum stratum) {
            for (const StarEdge& edge : star.edges) {
                const Point& to = complex.at(edge.vertex);
                if (stratum != Stratum::curve || std::abs((to - centre).norm() - radius) > 1e-9) {
                    continue; // in the plane
                }
                const Point chord = midpoint(complex.at(v), to);
                const Point place = curved_middle(complex, work, v, edge.vertex);
                const std::size_t i = edge.is_on_curve() ? 0 : 1;
                straight[i] = std::max(straight[i], std::abs((chord - centre).norm() - radius));
                curved[i] = std::max(curved[i], std::abs((place - centre).norm() - radius));
            }
        });
    EXPECT_GT(straight[0], 1e-3);
    EXPECT_LT(curved[0], 0.1 * straight[0]);
    EXPECT_GT(straight[1], 1e-3);
    EXPECT_LT(curved[1], 0.4 * straight[1]);
}

// Beside a bump of a flat sheet, normals are tilted: edges from there to the circle where the sheet
// ends are not bent as if all of it were curved.
TEST(Phases3, TiltedNormalsBendNoSheetUpToItsCurve) {
    Complex complex = divided_ball(1);
    Workspace work;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges; // from the sheet to the circle
    std::vector<std::uint32_t> sheet;
    for_each_interface_star(
        complex, [&](std::uint32_t v, const InterfaceStar& star, Stratum stratum) {
            if (stratum != Stratum::sheet || std::abs(plane(0)(complex.at(v))) > 1e-9) {
                return;
            }
            sheet.push_back(v);
            for (const StarEdge& edge : star.edges) {
                if (std::abs((complex.at(edge.vertex) - centre).norm() - radius) < 1e-9) {
                    edges.emplace_back(v, edge.vertex);
                }
            }
        });
    ASSERT_GT(edges.size(), 40U);
    double most = 0;
    for (const std::uint32_t bump : sheet) {
        const Point flat = complex.at(bump);
        complex.vertices[bump].position += 0.2 * h * planes.col(0);
        for (const auto& [v, end] : edges) {
            const double off = std::abs(plane(0)(curved_middle(complex, work, v, end)));
            most = std::max(most, v != bump ? off : 0);
        }
        complex.vertices[bump].position = flat;
    }
    EXPECT_LT(most, 0.02 * h);
}

} // namespace
} // namespace dsc3::test::phases_test
