// SPDX-License-Identifier: MIT
// How far vertices are asked to travel at a time: no farther than a sub-step allows, also where the
// flow becomes faster within the step or turns out to be faster than in the step before.
#include "support/courses.h"
#include "support/simulation_testing.h"

#include "dsc/queries/validate.h"

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
    // The first sub-step is halved until it leads no farther than twice what is aimed at.
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

} // namespace
} // namespace dsc::sub_steps_test
