// SPDX-License-Identifier: MIT
// The pieces of programs that the README and the guide show: compiled and run here, and compared
// with the text by guide_test.py.
#include "dsc/engine.h"
#include "geometric_flows/geometric_flows.h"
#include "replay/replay.h"
#include "support/random/scene.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

namespace dsc::pieces_test {
namespace {

class Pieces : public testing::Test {
protected:
    Complex<double> complex = test::disc_complex<double>(0.05);
    Options<double> options{.edge_length = 0.05};
};

TEST_F(Pieces, FlowsThatSeeTheInterface) {
    dsc::Simulation<double> simulation(complex, options);

    // Along the normal at speed 1; by curvature, in small steps; phase 1 moves and the others stay.
    const auto outwards = dsc::vertex_flow<double>(
        [](const auto& view, std::size_t i, double) { return dsc::normal(view, i); });
    const auto by_curvature =
        dsc::vertex_flow<double>([](const auto& view, std::size_t i, double) -> dsc::Point<double> {
            return -dsc::curvature(view, i) * dsc::normal(view, i);
        });
    const auto one_phase = dsc::vertex_flow<double>([](const auto& view, std::size_t i, double) {
        return dsc::borders_on(view, i, 1) ? dsc::Point<double>(1, 0) : dsc::Point<double>(0, 0);
    });
    simulation.step(outwards, 0, 0.01);

    EXPECT_NEAR(phase_area(complex, 1), std::numbers::pi * 0.26 * 0.26, 3e-3);
    simulation.step(by_curvature, 0.01, 1e-4);
    simulation.step(one_phase, 0.01, 0.01);
    EXPECT_TRUE(validate(complex).ok());
}

TEST_F(Pieces, EditsAreHeardAndReplayed) {
    Complex<double> first_complex = complex;
    dsc::Simulation<double> simulation(complex, options);
    const auto outwards = dsc::vertex_flow<double>(
        [](const auto& view, std::size_t i, double) { return dsc::normal(view, i); });

    std::vector<dsc::Edit> edits;
    simulation.add_listener([&](std::span<const dsc::Edit> some) {
        edits.insert(edits.end(), some.begin(), some.end());
    });
    // ... steps ...
    simulation.step(outwards, 0, 0.1);
    dsc::write_edits("run.edits", edits);
    dsc::replay<double>(first_complex, edits); // the same mesh, bit for bit

    EXPECT_FALSE(edits.empty());
    EXPECT_EQ(mesh_hash(first_complex), mesh_hash(complex));
    EXPECT_EQ(read_edits("run.edits").size(), edits.size());
    std::filesystem::remove("run.edits");
}

TEST_F(Pieces, GrowthAndCurvature) {
    const dsc::GrowthOptions<double> speeds{.speeds = {{1, 0, 1.0}}}; // phase 1 grows into phase 0
    dsc::Simulation<double> simulation(complex, options,
                                       dsc::make_executor(complex, options,
                                                          dsc::Parallel{.threads = 2},
                                                          dsc::growth_algorithm(complex, speeds)));
    simulation.step(dsc::growth(speeds), 0, 0.05);
    simulation.step(dsc::curvature_flow<double>({.mobility = 0.5}), 0.05, 0.01);

    const double radius = std::sqrt(0.3 * 0.3 - 2 * 0.5 * 0.01);
    EXPECT_NEAR(phase_area(complex, 1), std::numbers::pi * radius * radius, 3e-3);
}

TEST(Piece, ACurveBetweenTwoPhases) {
    const std::vector<dsc::Curve> curves{{.points = {{0, 0.5}, {1, 0.5}}, .left = 1, .right = 2}};
    auto complex = dsc::initial_complex<double>({}, curves, {.edge_length = 0.1});

    EXPECT_NEAR(phase_area(complex, 1), 0.5, 1e-12);
    EXPECT_NEAR(phase_area(complex, 2), 0.5, 1e-12);
}

TEST(Piece, ADomainOfAnyShape) {
    const auto circle = [](const dsc::Point<double>& centre, double radius, int n) {
        std::vector<dsc::Point<double>> points;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            points.emplace_back(centre.x() + radius * std::cos(angle),
                                centre.y() + radius * std::sin(angle));
        }
        return points;
    };

    const dsc::Polygon ring(circle({0, 0}, 1, 200), {circle({0, 0}, 0.4, 80)});
    const std::vector<dsc::Shape> shapes{{circle({0.7, 0.1}, 0.5, 100), 1}};
    const auto complex = dsc::initial_complex<double>(ring, shapes, {.edge_length = 0.05});

    EXPECT_NEAR(phase_area(complex, 0) + phase_area(complex, 1), std::numbers::pi * 0.84, 3e-3);
}

TEST_F(Pieces, AReportOfAStep) {
    dsc::Simulation<double> simulation(complex, options);
    const dsc::Velocity<double> velocity = [](auto, double, auto velocities) {
        std::ranges::fill(velocities, dsc::Point<double>(0.5, 0));
    };
    const dsc::StepReport report = simulation.step(velocity, 0, 0.1);
    if (report.unreached > 0 || report.gave_up != dsc::GiveUp::none) {
        // Some vertices did not arrive, or the step ended early at the time `report.reached`.
    }

    EXPECT_EQ(report.unreached, 0U);
}

} // namespace
} // namespace dsc::pieces_test
