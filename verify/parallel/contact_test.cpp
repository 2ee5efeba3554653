// SPDX-License-Identifier: MIT
// Two discs pressed against each other: the interface cannot pass through itself. Vertices that do
// not arrive are counted, are not tried again and again, and move on as soon as there is room.
#include "support/ways.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/queries/validate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dsc::contact_test {
namespace {

constexpr double h = 0.025;

Shape disc(double x, double radius) {
    Shape shape;
    shape.phase = 1;
    for (int i = 0; i < 48; ++i) {
        const double angle = 2 * std::numbers::pi * i / 48;
        shape.outline.emplace_back(x + radius * std::cos(angle), 0.5 + radius * std::sin(angle));
    }
    return shape;
}

// The left disc moves; the right one, which reaches to x = wall, stays.
constexpr double wall = 0.54;

Velocity<double> left_moves(double speed) {
    return [speed](std::span<const Point<double>> positions, double,
                   std::span<Point<double>> velocities) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            velocities[i] = {positions[i].x() < wall - 1e-6 ? speed : 0, 0};
        }
    };
}

class Contact : public testing::TestWithParam<test::Way> {};

TEST_P(Contact, IsNotTriedForEverAndEndsWhenThereIsRoom) {
    const Rectangle domain{{0, 0}, {1, 1}};
    InitialOptions initial;
    initial.edge_length = h;
    auto complex = initial_complex<double>(
        domain, std::vector<Shape>{disc(0.28, 0.18), disc(0.72, 0.18)}, initial);
    Options<double> options;
    options.edge_length = h;
    Simulation<double> simulation(complex, options,
                                  test::executor_of(GetParam(), complex, options));
    const Velocity<double> press = left_moves(0.3 * h);
    double time = 0;
    std::uint64_t missed = 0;
    std::uint64_t examined_at_first = 0; // in steps with an obstacle, before contact
    std::uint64_t examined_in_contact = 0;
    std::uint32_t last_passes = 0;
    for (int step = 0; step < 30; ++step, time += 1) {
        const StepReport report = simulation.step(press, time, 1);
        ASSERT_EQ(validate(complex).problem, "") << "step " << step;
        missed += report.unreached;
        if (report.unreached > 0 && examined_at_first == 0) {
            examined_at_first = report.operations.examined;
        }
        examined_in_contact = report.operations.examined;
        last_passes = report.passes;
    }
    EXPECT_GT(missed, 0U) << "nothing was in the way";
    // Each vertex is tried once, and those with an obstacle are not tried ten times over.
    EXPECT_LE(examined_in_contact, examined_at_first);
    EXPECT_LE(last_passes, 2U);
    std::size_t in_contact = 0;
    for (const auto& vertex : complex.vertices) {
        in_contact += (vertex.flags & vertex_dead) == 0 && is_in_contact(vertex) ? 1U : 0U;
    }
    EXPECT_GT(in_contact, 0U);

    // Apart again: all arrive, and no vertex stays marked.
    const Velocity<double> part = left_moves(-0.3 * h);
    std::uint64_t late = 0;
    for (int step = 0; step < 20; ++step, time += 1) {
        const StepReport report = simulation.step(part, time, 1);
        ASSERT_EQ(validate(complex).problem, "") << "step " << step << " of parting";
        late += step < 5 ? 0 : report.unreached;
    }
    EXPECT_EQ(late, 0U);
    for (const std::uint32_t v : simulation.interface()) {
        EXPECT_FALSE(is_in_contact(complex.vertices[v]));
    }
}

INSTANTIATE_TEST_SUITE_P(Strategies, Contact,
                         testing::Values(std::nullopt, Division::active, Division::cells),
                         [](const auto& one) { return test::name_of(one.param); });

} // namespace
} // namespace dsc::contact_test
