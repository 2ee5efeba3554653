// SPDX-License-Identifier: MIT
// Curvature flow by a solve: closed forms, junctions, walls, areas that are kept, bad input.
#include "support/simulation_testing.h"

#include "dsc/algorithm/interface_sight.h"
#include "dsc/base/error.h"
#include "geometric_flows/curvature_flow.h"
#include "topology/stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::curvature_flow_test {
namespace {

using std::numbers::pi;
using test::disc_complex;
using test::expect_sound;
using test::options_for;

// Jagged boundaries that become smooth at once have no corners to be kept.
Options<double> smooth_options(double h) {
    auto options = options_for<double>(h);
    options.interface.corner_degrees = 180;
    return options;
}

// --- circles: r^2 = r0^2 - 2 t times the multiplier ---------------------------------------------

// The relative error of the radius, by area, where the area should be half of the first; the
// fastest vertex goes `step` edge lengths in a step.
double error_of_circle(double h, double step, const CurvatureFlowOptions& flow, double factor) {
    constexpr double radius = 0.3;
    auto complex = disc_complex<double>(h, {0.5, 0.5}, radius);
    const auto options = options_for<double>(h);
    Simulation<double> simulation(complex, options);
    const double last = radius / std::sqrt(2.0);
    const double duration = radius * radius / 4 / factor;
    const int steps = static_cast<int>(std::ceil(duration * factor / (step * h * last)));
    const InterfaceMotion<double> motion = curvature_flow<double>(flow);
    for (int k = 0; k < steps; ++k) {
        EXPECT_EQ(simulation.step(motion, 0, duration / steps).unreached, 0U);
    }
    expect_sound(complex, simulation);
    return std::sqrt(phase_area(complex, 1) / pi) / last - 1;
}

TEST(CurvatureFlow, ShrinksACircleToSecondOrderWithStepsProportionalToH) {
    const std::array<double, 3> errors{error_of_circle(0.03, 0.25, {}, 1),
                                       error_of_circle(0.015, 0.25, {}, 1),
                                       error_of_circle(0.0075, 0.25, {}, 1)};
    EXPECT_LT(std::abs(errors[1]), 2e-4);
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.9) << errors[0] << ", " << errors[1];
    EXPECT_GT(std::log2(errors[1] / errors[2]), 1.9) << errors[1] << ", " << errors[2];
}

TEST(CurvatureFlow, IsStableForLongSteps) {
    EXPECT_LT(std::abs(error_of_circle(0.015, 2, {}, 1)), 1e-2);
}

TEST(CurvatureFlow, TakesTheMultipliersOfThePair) {
    const double plain = error_of_circle(0.03, 0.25, {}, 1);
    EXPECT_NEAR(error_of_circle(0.03, 0.25, {.tension = 2, .mobility = 3}, 6), plain, 1e-9);
    const CurvatureFlowOptions own{
        .tension = 9,
        .mobility = 9,
        .pairs = {{.one = 2, .other = 1, .tension = 7},
                  {.one = 1, .other = 0, .tension = 4, .mobility = 0.5}}};
    EXPECT_NEAR(error_of_circle(0.03, 0.25, own, 2), plain, 1e-9);
}

// The small disc is gone within a step or at its end; in some runs, edges of nearly no length are
// left of it for the next one.
TEST(CurvatureFlow, APieceThatVanishesHoldsNoOtherOne) {
    constexpr double h = 0.04;
    for (const double radius : {0.09, 0.095, 0.1, 0.105}) {
        for (const double dt : {2.5e-4, 5e-4, 1e-3}) {
            SCOPED_TRACE(std::to_string(radius) + ", " + std::to_string(dt));
            const std::vector<Shape> shapes{{test::circle_points({0.7, 0.7}, 0.15, 60), 2},
                                            {test::circle_points({0.3, 0.3}, radius, 60), 1}};
            auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
            Simulation<double> simulation(complex, options_for<double>(h));
            simulation.add_stage(std::make_shared<TopologyStage<double>>(
                TopologyOptions<double>{.rule = Topology::change}));
            const auto motion = curvature_flow<double>();
            for (double time = 0; time < 0.0075; time += dt) {
                EXPECT_EQ(simulation.step(motion, 0, dt).held, 0U);
                const double exact = std::sqrt(0.15 * 0.15 - 2 * (time + dt));
                EXPECT_NEAR(std::sqrt(phase_area(complex, 2) / pi) / exact, 1, 0.01);
            }
            EXPECT_EQ(phase_area(complex, 1), 0);
            expect_sound(complex, simulation);
        }
    }
}

// --- areas that are kept ------------------------------------------------------------------------

// An ellipse becomes the circle of its area.
TEST(CurvatureFlow, KeepsTheAreaOfAPhaseToRounding) {
    constexpr double h = 0.02;
    std::vector<Point<double>> ellipse = test::circle_points({0, 0}, 1, 90);
    for (auto& p : ellipse) {
        p = Point<double>(0.5 + 0.3 * p.x(), 0.5 + 0.15 * p.y());
    }
    const std::vector<Shape> shapes{{ellipse, 1}};
    auto complex = initial_complex<double>({}, shapes, {.edge_length = h});
    const auto options = options_for<double>(h);
    Simulation<double> simulation(complex, options);
    const double area = phase_area(complex, 1);
    const auto motion = curvature_flow<double>({.kept_areas = {{1, area}}});
    for (int step = 0; step < 300; ++step) {
        EXPECT_EQ(simulation.step(motion, 0, 0.25 * h * 0.1).unreached, 0U);
        ASSERT_NEAR(phase_area(complex, 1) / area, 1, 1e-12);
    }
    expect_sound(complex, simulation);
    const double radius = std::sqrt(area / pi);
    for (const std::uint32_t v : simulation.interface()) {
        const double from = (complex.position(Vertex{v}) - Point<double>(0.5, 0.5)).norm();
        EXPECT_NEAR(from / radius, 1, 0.01);
    }
}

// --- junctions ----------------------------------------------------------------------------------

// The direction in which an arm leaves its junction: that of the circle through its first three
// vertices.
double direction_of(const InterfaceView<double>& view, std::uint32_t junction,
                    std::uint32_t first) {
    const Point<double> one = view.positions[first] - view.positions[junction];
    const std::uint32_t second =
        view.next[first] == junction ? view.previous[first] : view.next[first];
    const Point<double> two = view.positions[second] - view.positions[first];
    const double turn = std::atan2(one.x() * two.y() - one.y() * two.x(), one.dot(two));
    return std::atan2(one.y(), one.x()) - turn * one.norm() / (one.norm() + two.norm());
}

// A disc between two half-planes, whose areas are kept, becomes a lens.
struct Lens {
    explicit Lens(double h, const std::vector<PairCurvature>& pairs = {})
        : complex(disc_complex<double>(h, {0.5, 0.5}, 0.2)) {
        for (const Triangle t : triangles(complex, 0)) {
            const auto [a, b, c] = complex.vertices_of(t);
            const double x =
                complex.position(a).x() + complex.position(b).x() + complex.position(c).x();
            complex.set_phase(t, x < 1.5 ? 2 : 3);
        }
        const auto options = smooth_options(h);
        Simulation<double> simulation(complex, options);
        std::vector<KeptArea> areas;
        for (const Phase phase : {1U, 2U, 3U}) {
            areas.push_back({phase, phase_area(complex, phase)});
        }
        const auto motion = curvature_flow<double>({.pairs = pairs, .kept_areas = areas});
        for (double time = 0; time < 0.3; time += 0.05 * h) {
            EXPECT_EQ(simulation.step(motion, 0, 0.05 * h).unreached, 0U);
            for (const KeptArea& kept : areas) {
                EXPECT_NEAR(phase_area(complex, kept.phase) / kept.area, 1, 1e-9);
            }
        }
        expect_sound(complex, simulation);
        const auto list = simulation.interface();
        InterfaceGraph<double> graph;
        graph.build(complex, list);
        std::vector<Point<double>> positions;
        for (const std::uint32_t v : list) {
            positions.push_back(complex.position(Vertex{v}));
        }
        look(graph.view(complex, positions));
    }

    void look(const InterfaceView<double>& view) {
        for (const std::uint32_t junction : view.junctions) {
            const auto arms = arms_of(view, junction);
            for (std::size_t k = 0; k < arms.size() && arms.size() == 3; ++k) {
                const auto& arm = arms[k];
                const bool is_wall = arm.left == border_phase || arm.right == border_phase;
                const double here = direction_of(view, junction, arm.neighbour);
                if (view.is_on_boundary(junction)) {
                    if (!is_wall) {
                        wall_degrees.push_back(std::abs(here) * 180 / pi);
                    }
                    continue;
                }
                const double ahead = direction_of(view, junction, arms[(k + 1) % 3].neighbour);
                const double angle = std::remainder(ahead - here, 2 * pi) * 180 / pi;
                (arm.left == 1 ? disc_degrees : other_degrees)
                    .push_back(angle < 0 ? angle + 360 : angle);
            }
        }
    }

    Complex<double> complex;
    std::vector<double> disc_degrees;  ///< of the lens, at its two tips
    std::vector<double> other_degrees; ///< of the other two phases there
    std::vector<double> wall_degrees;  ///< where the line between these two ends
};

TEST(CurvatureFlow, ThreePhasesRelaxTo120DegreesAnd90AtTheWall) {
    const Lens lens(0.02);
    ASSERT_EQ(lens.disc_degrees.size(), 2U);
    ASSERT_EQ(lens.other_degrees.size(), 4U);
    ASSERT_EQ(lens.wall_degrees.size(), 2U);
    for (const auto& list : {lens.disc_degrees, lens.other_degrees}) {
        for (const double angle : list) {
            EXPECT_NEAR(angle, 120, 0.5);
        }
    }
    for (const double angle : lens.wall_degrees) {
        EXPECT_NEAR(angle, 90, 0.5);
    }
}

// Young's law: 2 cos(angle / 2) = tension of the line over that of the lens.
TEST(CurvatureFlow, TensionsSetTheAngles) {
    const Lens lens(0.02, {{.one = 2, .other = 3, .tension = 1.4}});
    ASSERT_EQ(lens.disc_degrees.size(), 2U);
    for (const double angle : lens.disc_degrees) {
        EXPECT_NEAR(angle, 2 * std::acos(0.7) * 180 / pi, 1);
    }
}

// --- contact angles -----------------------------------------------------------------------------

// A half-disc on the floor, whose area is kept, becomes the cap of the angle that is asked for.
TEST(CurvatureFlow, WallsSetTheContactAngle) {
    constexpr double h = 0.02;
    constexpr double radius = 0.2;
    for (const double degrees : {60.0, 90.0, 120.0}) {
        SCOPED_TRACE(degrees);
        const double angle = degrees * pi / 180;
        Curve arc{{}, 1, 0};
        arc.points.emplace_back(0.5 + radius, 0);
        for (int i = 1; i < 40; ++i) {
            arc.points.emplace_back(0.5 + radius * std::cos(pi * i / 40),
                                    radius * std::sin(pi * i / 40));
        }
        arc.points.emplace_back(0.5 - radius, 0);
        const std::vector<Curve> curves{arc};
        auto complex = initial_complex<double>({}, curves, {.edge_length = h});
        const auto options = smooth_options(h);
        Simulation<double> simulation(complex, options);
        const double area = phase_area(complex, 1);
        // Both have a share, of which only the difference counts.
        const auto motion = curvature_flow<double>(
            {.walls = {{1, 0.25 - std::cos(angle)}, {0, 0.25}}, .kept_areas = {{1, area}}});
        for (double time = 0; time < 0.15; time += 0.05 * h) {
            EXPECT_EQ(simulation.step(motion, 0, 0.05 * h).unreached, 0U);
        }
        expect_sound(complex, simulation);
        const double cap = std::sqrt(area / (angle - std::sin(angle) * std::cos(angle)));
        double height = 0;
        double left = 1;
        double right = 0;
        for (const std::uint32_t v : simulation.interface()) {
            const Point<double>& p = complex.position(Vertex{v});
            height = std::max(height, p.y());
            left = std::min(left, p.y() == 0 ? p.x() : 1);
            right = std::max(right, p.y() == 0 ? p.x() : 0);
        }
        EXPECT_NEAR(height, cap * (1 - std::cos(angle)), 0.01 * cap);
        EXPECT_NEAR(right - left, 2 * cap * std::sin(angle), 0.02 * cap);
        EXPECT_NEAR(phase_area(complex, 1) / area, 1, 1e-9);
    }
}

// --- what stays, and what is refused ------------------------------------------------------------

TEST(CurvatureFlow, LockedVerticesStay) {
    auto complex = disc_complex<double>(0.03);
    const auto options = options_for<double>(0.03);
    Simulation<double> simulation(complex, options);
    const Vertex locked{simulation.interface()[5]};
    complex.set_locked(locked, true);
    const Point<double> before = complex.position(locked);
    const double area = phase_area(complex, 1);
    for (int step = 0; step < 10; ++step) {
        EXPECT_EQ(simulation.step(curvature_flow<double>(), 0, 0.001).unreached, 0U);
    }
    EXPECT_EQ(complex.position(locked), before);
    EXPECT_LT(phase_area(complex, 1), area - 0.05);
    expect_sound(complex, simulation);
}

TEST(CurvatureFlow, MovesAComplexOfFloats) {
    auto complex = disc_complex<float>(0.03, {0.5, 0.5}, 0.3);
    const auto options = options_for<float>(0.03);
    Simulation<float> simulation(complex, options);
    for (int step = 0; step < 20; ++step) {
        EXPECT_EQ(simulation.step(curvature_flow<float>(), 0, 0.001F).unreached, 0U);
    }
    expect_sound(complex, simulation);
    EXPECT_NEAR(phase_area(complex, 1), pi * (0.09 - 0.04), 3e-3);
}

TEST(CurvatureFlow, RefusesBadOptions) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto is_refused = [](const CurvatureFlowOptions& options) {
        EXPECT_THROW((void)curvature_flow<double>(options), InputError);
    };
    is_refused({.tension = -1});
    is_refused({.tension = nan});
    is_refused({.mobility = 0});
    is_refused({.pairs = {{.one = 1, .other = 1}}});
    is_refused({.pairs = {{.one = 1, .other = border_phase}}});
    is_refused({.pairs = {{.one = 1, .other = 2, .tension = -0.5}}});
    is_refused({.pairs = {{.one = 1, .other = 2}, {.one = 2, .other = 1}}});
    is_refused({.walls = {{1, nan}}});
    is_refused({.walls = {{border_phase, 1}}});
    is_refused({.walls = {{1, 1}, {1, 2}}});
    is_refused({.kept_areas = {{0, 0.1}}});
    is_refused({.kept_areas = {{1, -0.1}}});
    is_refused({.kept_areas = {{1, 0.1}, {1, 0.2}}});
    EXPECT_NO_THROW((void)curvature_flow<double>(
        {.tension = 0, .pairs = {{.one = 1, .other = 2}, {.one = 2, .other = 3}}}));
}

} // namespace
} // namespace dsc::curvature_flow_test
