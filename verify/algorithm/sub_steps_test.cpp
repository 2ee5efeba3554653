// SPDX-License-Identifier: MIT
// How far vertices are asked to travel at a time: no farther than a sub-step allows, also where the
// flow becomes faster within the step; and the step that follows from a tolerance.
#include "support/courses.h"
#include "support/simulation_testing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "replay/mesh_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dsc::sub_steps_test {
namespace {

using test::disc_complex;
using test::options_for;
using test::pointwise;

// A vertex that is to be looked at bears the number of the pass, of 32 bits: when they come to an
// end, none is passed over.
class Stamps : public testing::TestWithParam<test::Course> {};

TEST_P(Stamps, BeginAnewAfterTheLast) {
    std::vector<std::uint64_t> hashes;
    for (const std::uint32_t left : {0xffffffffU, 0U, 1U, 2U, 5U}) {
        auto complex = test::disc();
        // As an earlier simulation left it behind.
        complex.vertices[0].stamp = 0xffffffffU - left;
        const auto simulation =
            test::make_simulation(complex, {.edge_length = test::disc_h}, GetParam());
        for (int step = 0; step < 8; ++step) {
            EXPECT_EQ(simulation->step(test::swirl, 0.02 * step, 0.02).unreached, 0U);
        }
        hashes.push_back(mesh_hash(complex));
        EXPECT_EQ(hashes.back(), hashes.front()) << left;
    }
}

INSTANTIATE_TEST_SUITE_P(Ways, Stamps, testing::ValuesIn(test::all_courses), test::course_name);

constexpr double edge = 0.025;

// The farthest that a single move has taken a vertex, in edge lengths.
class Farthest {
public:
    Farthest(const Complex<double>& complex, Simulation<double>& simulation) {
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            at_.push_back(complex.position(Vertex{v}));
        }
        simulation.add_listener([this](std::span<const Edit> edits) {
            for (const Edit& edit : edits) {
                if (edit.kind == EditKind::split || edit.kind == EditKind::move) {
                    note(edit);
                }
            }
        });
    }
    [[nodiscard]] double value() const { return farthest_ / edge; }

private:
    void note(const Edit& edit) {
        const std::size_t id = edit.vertex.id;
        at_.resize(std::max(at_.size(), id + 1));
        const Point<double> to(edit.x, edit.y);
        if (edit.kind == EditKind::move && edit.reason == MoveReason::flow) {
            farthest_ = std::max(farthest_, (to - at_[id]).norm());
        }
        at_[id] = to;
    }

    std::vector<Point<double>> at_;
    double farthest_ = 0;
};

TEST(SubSteps, AreShorterWhereTheFlowBecomesFasterWithinThem) {
    auto complex = disc_complex<double>(edge, {0.25, 0.5}, 0.12);
    const auto options = options_for<double>(edge);
    Simulation<double> simulation(complex, options);
    const Farthest farthest(complex, simulation);
    // At rest when the step begins; 8 edge lengths in all.
    const auto flow = pointwise<double>(
        [](const Point<double>&, double time) { return Point<double>(16 * edge * time, 0); });
    const StepReport report = simulation.step(flow, 0, 1);
    EXPECT_EQ(report.unreached, 0U);
    // The first sub-step is halved until it leads no farther than twice what is targets at.
    EXPECT_LE(farthest.value(), 2 * options.sub_step);
    EXPECT_GE(report.sub_steps, static_cast<std::uint32_t>(8 / (2 * options.sub_step)));
}

TEST(SubSteps, AreAsManyAsTheWayAsksFor) {
    auto complex = disc_complex<double>(edge, {0.25, 0.5}, 0.12);
    const auto options = options_for<double>(edge);
    Simulation<double> simulation(complex, options);
    const Farthest farthest(complex, simulation);
    const StepReport report = simulation.step(test::constant<double>(5.9 * edge, 0), 0, 1);
    EXPECT_EQ(report.sub_steps, static_cast<std::uint32_t>(std::ceil(5.9 / options.sub_step)));
    EXPECT_LE(farthest.value(), options.sub_step * (1 + 1e-9));
}

class Turning : public testing::Test {
protected:
    static Complex<double> disc(double h) {
        const std::vector<Shape> shapes{{test::circle_points({0.5, 0.5}, 0.2, 40), 1}};
        return initial_complex<double>({}, shapes, {.edge_length = h});
    }
    static double farthest_from_circle(const Complex<double>& complex,
                                       const Simulation<double>& simulation) {
        double worst = 0;
        for (const std::uint32_t v : simulation.interface()) {
            const Point<double> d = complex.position(Vertex{v}) - Point<double>(0.5, 0.5);
            worst = std::max(worst, std::abs(d.norm() - 0.2));
        }
        return worst;
    }
    // Counter-clockwise about the middle of the domain.
    static Velocity<double> turn(double speed) {
        return pointwise<double>([=](const Point<double>& p, double) {
            return Point<double>(-speed * (p.y() - 0.5), speed * (p.x() - 0.5));
        });
    }
};

TEST_F(Turning, TheToleranceChoosesTheStep) {
    std::uint32_t first_steps = 0;
    std::uint32_t last_steps = 0;
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
        auto complex = disc(0.05);
        auto options = options_for<double>(0.05);
        options.integrator = Integrator::adaptive;
        options.tolerance = tolerance;
        options.interface.coarsening = Coarsening::never;
        Simulation<double> simulation(complex, options);
        std::uint32_t steps = 0;
        double estimate = 0;
        for (int i = 0; i < 5; ++i) {
            const StepReport report = simulation.step(turn(20), 0.1 * i, 0.1);
            EXPECT_EQ(report.unreached, 0U);
            steps += report.sub_steps;
            estimate = std::max(estimate, report.error);
        }
        EXPECT_LE(estimate, tolerance * 0.05);
        EXPECT_GE(steps, last_steps);
        // The sum of the estimated errors bounds the error.
        EXPECT_LE(farthest_from_circle(complex, simulation), steps * tolerance * 0.05);
        first_steps = first_steps == 0 ? steps : first_steps;
        last_steps = steps;
    }
    EXPECT_GT(last_steps, 2 * first_steps); // more than the limit on displacements requires
}

TEST_F(Turning, TheStepGrowsAgainWhereTheFlowIsSlower) {
    auto complex = disc(0.05);
    auto options = options_for<double>(0.05);
    options.integrator = Integrator::adaptive;
    options.tolerance = 1e-6;
    Simulation<double> simulation(complex, options);
    EXPECT_GT(simulation.step(turn(20), 0, 0.1).sub_steps, 20U);
    EXPECT_LT(simulation.step(turn(1), 0.1, 1).sub_steps, 30U);
    EXPECT_LT(simulation.step(turn(1), 1.1, 1).sub_steps, 30U);
}

// A flow that is rough for a moment asks for sub-steps so short that the whole step would be
// thousands of them; that is no reason to give it up.
TEST_F(Turning, AMomentOfRoughnessDoesNotMakeTheRestOfTheStepShort) {
    auto complex = disc(0.05);
    auto options = options_for<double>(0.05);
    options.integrator = Integrator::adaptive;
    options.tolerance = 1e-6;
    options.max_sub_steps = 300;
    Simulation<double> simulation(complex, options);
    const auto rough = pointwise<double>([](const Point<double>& p, double time) {
        const bool is_rough = time > 0.1 && time < 0.102;
        return Point<double>(0.1, is_rough ? 1e-3 * std::sin(1e7 * p.y()) : 0.0);
    });
    const StepReport smooth = simulation.step(rough, 0, 0.1);
    const StepReport within = simulation.step(rough, 0.1, 0.0015);
    const StepReport beyond = simulation.step(rough, 0.1015, 0.3985);
    for (const StepReport& one : {smooth, within, beyond}) {
        EXPECT_EQ(one.gave_up, GiveUp::none);
        EXPECT_EQ(one.unreached, 0U);
        EXPECT_LE(one.error, 1e-6 * 0.05);
    }
    EXPECT_GT(within.sub_steps, 5U);
    EXPECT_EQ(validate(complex).problem, "");
    for (const std::uint32_t v : simulation.interface()) {
        EXPECT_NEAR((complex.position(Vertex{v}) - Point<double>(0.55, 0.5)).norm(), 0.2, 1e-4);
    }
}

// Thin layers make room for one another in turn, the first to move being the last in the list.
constexpr double layers_h = 0.02;
constexpr double thickness = 0.025 * layers_h;
constexpr int layer_count = 40;

Complex<double> layers() {
    std::vector<Shape> shapes;
    for (int i = 0; i < layer_count; ++i) {
        const double low = 0.6 + 2 * thickness * i;
        const double high = low + thickness;
        shapes.push_back({{{0.2, low}, {0.8, low}, {0.8, high}, {0.2, high}}, 1});
    }
    return initial_complex<double>({{0, 0}, {1, 1}}, shapes, {.edge_length = layers_h});
}

class Layers : public testing::TestWithParam<test::Course> {};

TEST_P(Layers, AllArriveAndKeepTheirArea) {
    auto complex = layers();
    const auto simulation =
        test::make_simulation(complex, options_for<double>(layers_h), GetParam());
    const StepReport report = simulation->step(test::constant<double>(0, 0.6 * layers_h), 0, 1);
    EXPECT_EQ(report.unreached, 0U);
    EXPECT_EQ(report.gave_up, GiveUp::none);
    EXPECT_NEAR(phase_area(complex, 1), layer_count * 0.6 * thickness, 1e-12);
    EXPECT_EQ(validate(complex).problem, "");
}

INSTANTIATE_TEST_SUITE_P(Courses, Layers, testing::ValuesIn(test::all_courses), test::course_name);

TEST(OneLayerAfterAnother, AStepThatEndsByTheNumberOfPassesGivesUp) {
    auto complex = layers();
    auto options = options_for<double>(layers_h);
    options.max_passes = 4;
    Simulation<double> simulation(complex, options);
    const StepReport report = simulation.step(test::constant<double>(0, 1.2 * layers_h), 0, 1);
    EXPECT_EQ(report.gave_up, GiveUp::too_many_passes);
    EXPECT_GT(report.unreached, 0U);
    EXPECT_EQ(report.sub_steps, 1U);
    EXPECT_NEAR(report.reached, 0.5, 1e-12);
    EXPECT_EQ(validate(complex).problem, "");
}

} // namespace
} // namespace dsc::sub_steps_test
