// SPDX-License-Identifier: MIT
// Growth along the normal: speeds by pairs of phases, by position and time; junctions and sides of
// the domain; refusals and failures.
#include "support/refusal.h"
#include "support/topology/growth_testing.h"

#include "dsc/base/error.h"
#include "dsc/parallel/parallel.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace dsc::growth_rules_test {
namespace {

using test::complex_of;
using test::difference;
using test::GrowingShape;
using test::options_for;
using test::Outline;

const Outline small_square{{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}};

// A grid over the unit square, sheared by `slant` to the right. The phase of a square is given by
// its lower left corner before shearing; grid lines between different phases are interfaces. With
// `taper` the square is a trapezoid, lower by that share on the right.
template <class PhaseAt>
Complex<double> grid(int n, double slant, PhaseAt phase_at, double taper = 0) {
    std::vector<Point<double>> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Phase> phases;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double y = static_cast<double>(j) / n;
            const double x = static_cast<double>(i) / n;
            points.emplace_back(x + slant * y, 0.5 + (y - 0.5) * (1 - taper * x));
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (n + 1) + i);
            const auto above = a + static_cast<std::uint32_t>(n) + 1;
            triangles.push_back({a, a + 1, above + 1});
            triangles.push_back({a, above + 1, above});
            phases.resize(triangles.size(), phase_at(i, j));
        }
    }
    return make_complex<double>(points, triangles, phases);
}

TEST(GrowthRules, AFactorByPlaceIsThatOfThePlace) {
    // A straight front whose speed is its position x: x = 0.3 exp(t).
    auto complex = grid(50, 0, [](int i, int) { return Phase{i < 15}; });
    GrowingShape growing(complex, 0.02,
                         {.speeds = {{1, 0, 1.0}},
                          .factor = [](const Point<double>& place, double) { return place.x(); }});
    EXPECT_EQ(growing.run(0, 0.5), 0U);
    test::expect_sound(complex, growing.simulation());
    EXPECT_NEAR(phase_area(complex, 1), 0.3 * std::exp(0.5), 1e-9);
}

TEST(GrowthRules,
     AnEndOnTheDomainBoundaryKeepsUpWithASheetThatLeansForwardAndIsATipWhereItLeansBack) {
    // By the principle of Huygens: the end that leans forward slides as fast as the sheet's offset
    // meets the domain boundary; from the end that leans back, an arc spreads about the place of
    // the tip.
    constexpr double distance = 0.1;
    for (const double slant : {0.0, 0.5, -0.5, 1.0, -1.0}) {
        auto complex = grid(50, slant, [](int i, int) { return Phase{i < 15}; });
        GrowingShape growing(complex, 0.02, {.speeds = {{1, 0, 1.0}}});
        EXPECT_EQ(growing.run(0, distance), 0U);
        test::expect_sound(complex, growing.simulation());
        // A tip that moved as fast as the sheet's offset would sweep this area beyond the arc. No
        // fan opens on the domain boundary, so the arc has few vertices.
        const double beyond_arc =
            distance * distance / 2 * (std::abs(slant) - std::atan(std::abs(slant)));
        EXPECT_NEAR(phase_area(complex, 1), 0.3 + distance * std::hypot(slant, 1) - beyond_arc,
                    1e-12 + beyond_arc / 3)
            << slant;
    }
}

TEST(GrowthRules, EndsOfASheetThatLeansForwardAreExact) {
    constexpr double taper = 0.5;
    auto complex = grid(
        50, 0, [](int i, int) { return Phase{i < 15}; }, taper);
    GrowingShape growing(complex, 0.02, {.speeds = {{1, 0, 1.0}}});
    EXPECT_EQ(growing.run(0, 0.1), 0U);
    test::expect_sound(complex, growing.simulation());
    EXPECT_NEAR(phase_area(complex, 1), 0.4 - taper * 0.4 * 0.4 / 2, 1e-12);
}

TEST(GrowthRules, AJunctionAtATipOfWhatGrowsIsNoFasterThanItsSheets) {
    // Two triangles make a square that grows: its tips open into arcs, those at the seam's ends
    // too.
    constexpr double side = 0.3;
    constexpr double distance = 0.1;
    const Point<double> low(0.35, 0.35);
    const Point<double> high(0.65, 0.65);
    const std::vector<Curve> curves{
        {{low, {0.65, 0.35}, high}, 1, 0}, {{high, {0.35, 0.65}, low}, 2, 0}, {{low, high}, 2, 1}};
    auto complex = initial_complex<double>({{0, 0}, {1, 1}}, curves, {.edge_length = 0.01});
    GrowingShape growing(complex, 0.01, {.speeds = {{1, 0, 1.0}, {2, 0, 1.0}}});
    EXPECT_EQ(growing.run(0, distance), 0U);
    test::expect_sound(complex, growing.simulation());
    const double exact = side * side + 4 * side * distance + std::numbers::pi * distance * distance;
    // Tips that stayed sharp would add 2e-3 to each.
    EXPECT_NEAR(phase_area(complex, 1), exact / 2, 3e-4);
    EXPECT_NEAR(phase_area(complex, 2), exact / 2, 3e-4);
}

TEST(GrowthRules, AJunctionMovesWithTheSheetsThatMeetThere) {
    // Phases 1 and 2 side by side below phase 0, into which both grow.
    auto complex = grid(50, 0, [](int i, int j) {
        return j >= 25 ? exterior_phase : Phase{1U + static_cast<unsigned>(i >= 20)};
    });
    GrowingShape growing(complex, 0.02, {.speeds = {{1, 0, 1.0}, {0, 2, -1.0}}});
    EXPECT_EQ(growing.run(0, 0.1), 0U);
    test::expect_sound(complex, growing.simulation());
    EXPECT_NEAR(phase_area(complex, 1), 0.4 * 0.6, 1e-12);
    EXPECT_NEAR(phase_area(complex, 2), 0.6 * 0.6, 1e-12);
}

TEST(GrowthRules, TwoFrontsSayWhereTheirSeamGoesOnWhateverItsDirection) {
    // Two fronts that meet at the bottom of a valley, from which a seam leads down to the left.
    const Point<double> end(0.5, 0.4);
    const std::vector<Curve> curves{
        {{{0, 0.7}, end}, 0, 1}, {{end, {1, 0.7}}, 0, 2}, {{{0.3, 0}, end}, 1, 2}};
    auto complex = initial_complex<double>({{0, 0}, {1, 1}}, curves, {.edge_length = 0.02});
    GrowingShape growing(complex, 0.02, {.speeds = {{1, 0, 1.0}, {2, 0, 1.0}}});
    constexpr double time = 0.1;
    EXPECT_EQ(growing.run(0, time), 0U);
    test::expect_sound(complex, growing.simulation());
    const double up = time * std::hypot(0.5, 0.3) / 0.5; // of the end of the seam, and of the sides
    EXPECT_NEAR(phase_area(complex, 1), 0.235 + 0.5 * up, 6e-4);
    EXPECT_NEAR(phase_area(complex, 2), 0.315 + 0.5 * up, 6e-4);
}

TEST(GrowthRules, PhasesWithoutASpeedStay) {
    auto complex = complex_of(small_square, 0.02);
    GrowingShape growing(complex, 0.02, {});
    EXPECT_EQ(growing.run(0, 0.1), 0U);
    EXPECT_EQ(difference(complex, {small_square}), 0);
}

// --- what is refused ----------------------------------------------------------------------------

std::string refusal(const GrowthOptions<double>& options) {
    auto complex = complex_of(small_square, 0.05);
    const std::string sentence = test::refusal([&] { (void)growth_algorithm(complex, options); });
    EXPECT_EQ(fan_rays(complex) == nullptr, !sentence.empty());
    return sentence;
}

TEST(GrowthRules, RefuseSpeedsThatMakeNoSense) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal({.speeds = {{1, 0, 1.0}}}), "");
    EXPECT_EQ(refusal({.speeds = {{1, 0, nan}}}),
              "growth.speeds: 1 into 0: value out of range: got nan; allowed: a finite speed");
    EXPECT_EQ(refusal({.speeds = {{1, 1, 1.0}}}),
              "growth.speeds: not a pair of phases: got 1 into 1; allowed: two different phases of "
              "the complex");
    EXPECT_EQ(refusal({.speeds = {{1, 0, 1.0}, {0, 1, 1.0}}}),
              "growth.speeds: two speeds for one pair of phases: got 0 into 1; allowed: each pair "
              "once");
    EXPECT_EQ(refusal({.speeds = {{1, 7, 1.0}}}),
              "growth.speeds: a phase that the complex does not have: got 7; allowed: a phase of "
              "one of its triangles");
    EXPECT_THROW((void)growth<double>({.speeds = {{1, border_phase, 1.0}}}), InputError);
}

TEST(GrowthRules, RefuseAnglesThatMakeNoSense) {
    EXPECT_NE(refusal({.speeds = {}, .open_degrees = 0}), "");
    EXPECT_NE(refusal({.speeds = {}, .fan_degrees = 30}), "");
    EXPECT_NE(refusal({.speeds = {}, .smooth_degrees = 31}), "");
    EXPECT_NE(refusal({.speeds = {}, .notch_degrees = 10}), "");
    EXPECT_NE(refusal({.speeds = {}, .max_notch = 0.5}), "");
    EXPECT_NE(refusal({.speeds = {}, .max_notch = std::numeric_limits<double>::infinity()}), "");
}

// --- what fails ---------------------------------------------------------------------------------

TEST(GrowthRules, RefuseASimulationWithoutTheirAlgorithm) {
    constexpr double h = 0.02;
    const auto flow = growth<double>({.speeds = {{1, 0, 1.0}}});
    for (const std::uint32_t threads : {1U, 2U}) {
        auto complex = complex_of(small_square, h);
        Simulation<double> simulation(complex, test::options_for<double>(h),
                                      Parallel{.threads = threads});
        test::expect_refusal([&] { (void)simulation.step(flow, 0, 0.01); }, "growth");
        test::expect_sound(complex, simulation);
    }
}

TEST(GrowthRules, WhatTheFactorThrowsArrives) {
    auto complex = complex_of(small_square, 0.02);
    const auto factor = [](const Point<double>&, double time) -> double {
        return time < 0.05 ? 1 : throw std::domain_error("no speed known");
    };
    GrowingShape growing(complex, 0.02, {.speeds = {{1, 0, 1.0}}, .factor = factor});
    EXPECT_THROW((void)growing.run(0, 0.1), std::domain_error);
    test::expect_sound(complex, growing.simulation());
}

TEST(GrowthRules, AVertexWithoutAFiniteSpeedIsHeld) {
    auto complex = complex_of(small_square, 0.02);
    const auto factor = [](const Point<double>& place, double) {
        return place.x() < 0.41 ? std::nan("") : 1.0;
    };
    GrowingShape growing(complex, 0.02, {.speeds = {{1, 0, 1.0}}, .factor = factor});
    EXPECT_GT(growing.run(0, 0.02), 0U);
    test::expect_sound(complex, growing.simulation());
}

} // namespace
} // namespace dsc::growth_rules_test
