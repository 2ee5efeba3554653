// SPDX-License-Identifier: MIT
// Grains on hand-made meshes, and their growth against the law of von Neumann and Mullins.
#include "measures/grains.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace dsc::test::grains_test {
namespace {

using namespace dsc::scenes;

using std::numbers::pi;

// A grain of phase 1, a regular polygon of this area, with n neighbours of phases 2 to n + 1, or of
// two phases in turn. Around it, a wall.
template <class Real>
Complex<Real> grain_in_ring(std::uint32_t n, double area, bool of_two_phases = false) {
    const double radius = std::sqrt(2 * area / (n * std::sin(2 * pi / n)));
    std::vector<Point<Real>> points{{0, 0}};
    for (const double r : {radius, 2 * radius}) {
        for (std::uint32_t i = 0; i < n; ++i) {
            points.emplace_back(static_cast<Real>(r * std::cos(2 * pi * i / n)),
                                static_cast<Real>(r * std::sin(2 * pi * i / n)));
        }
    }
    std::vector<Indices> list;
    std::vector<Phase> phases;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t a = 1 + i;
        const std::uint32_t b = 1 + (i + 1) % n;
        const Phase beyond = of_two_phases ? 2 + i % 2 : 2 + i;
        list.insert(list.end(), {Indices{0, a, b}, Indices{a, a + n, b + n}, Indices{a, b + n, b}});
        phases.insert(phases.end(), {1, beyond, beyond});
    }
    return build<Real>(points, list, phases);
}

TEST(Grains, SidesAreCounted) {
    for (std::uint32_t n = 3; n <= 9; ++n) {
        const auto grains = measure_grains(grain_in_ring<double>(n, 2));
        ASSERT_EQ(grains.size(), n + 1);
        EXPECT_EQ(grains[0].phase, 1U);
        EXPECT_EQ(grains[0].sides, n);
        EXPECT_EQ(grains[0].holes, 0U);
        EXPECT_NEAR(grains[0].area, 2, 1e-14);
        EXPECT_NEAR(grains[0].centre.norm(), 0, 1e-14);
        EXPECT_FALSE(grains[0].touches_border);
        for (std::size_t i = 1; i <= n; ++i) {
            EXPECT_TRUE(grains[i].touches_border);
        }
        const GrainStatistics statistics = summarise(grains);
        EXPECT_EQ(statistics.count, n + 1);
        ASSERT_EQ(statistics.with_sides.size(), n + 1);
        EXPECT_EQ(statistics.with_sides[n], 1U);
        double sum = 0;
        for (const Grain& grain : grains) {
            sum += grain.area;
        }
        EXPECT_NEAR(sum, 8, 1e-13);
        EXPECT_NEAR(statistics.mean_area, sum / (n + 1), 1e-14);
    }
}

// Phase 1 of the square 2 <= x, y < 6 has a hole of 2 x 2 squares, itself of two phases.
TEST(Grains, WithAHoleInside) {
    auto K = grid<double>(8);
    for (const Triangle t : triangles(K)) {
        const std::uint32_t i = (t.id - 1) / 2 % 8;
        const std::uint32_t j = (t.id - 1) / 16;
        const auto within = [&](std::uint32_t low, std::uint32_t high) {
            return std::min(i, j) >= low && std::max(i, j) < high;
        };
        K.set_phase(t, within(3, 5) ? 2 + i % 2 : within(2, 6) ? 1 : 0);
    }
    const auto grains = measure_grains(K);
    ASSERT_EQ(grains.size(), 4U);
    const Grain& ring = grains[1];
    EXPECT_EQ(ring.phase, 1U);
    EXPECT_EQ(ring.sides, 2U) << "one curve outside has no junction, the one inside has two";
    EXPECT_EQ(ring.holes, 1U);
    EXPECT_DOUBLE_EQ(ring.area, 12);
    EXPECT_NEAR((ring.centre - Point<double>(4, 4)).norm(), 0, 1e-14);
    EXPECT_EQ(grains[2].sides, 2U);
    EXPECT_DOUBLE_EQ(growth_by_sides(ring), 2 * pi / 3);
    EXPECT_DOUBLE_EQ(growth_by_sides(grains[2], 3), -4 * pi);
}

TEST(Grains, GrowthByTheLawIsRecognised) {
    const double duration = 0.01;
    for (std::uint32_t n = 3; n <= 9; ++n) {
        const double rate = 2 * pi / 3 * (static_cast<double>(n) - 6);
        const auto before = measure_grains(grain_in_ring<double>(n, 1));
        for (const double excess : {0.0, 0.05}) {
            const double grown = rate == 0 ? pi / 3 * 2 * excess : rate * (1 + excess);
            const auto after = measure_grains(grain_in_ring<double>(n, 1 + grown * duration));
            const auto growth =
                measure_growth(before, after, {.duration = duration, .multiplier = 2});
            ASSERT_EQ(growth.size(), 1U) << "those at the wall do not count";
            EXPECT_EQ(growth[0].grain, before[0]);
            EXPECT_NEAR(growth[0].rate, grown, 1e-11);
            EXPECT_DOUBLE_EQ(growth[0].expected, rate);
            EXPECT_NEAR(growth[0].error_rel, excess, 1e-11);
        }
    }
}

TEST(Grains, AreMatchedByPhaseAndPlace) {
    const auto grain = [](Phase phase, double x, double area, std::uint32_t sides) {
        return Grain{.phase = phase, .area = area, .centre = {x, 0}, .sides = sides};
    };
    const std::vector<Grain> before{grain(1, 0, 5, 6), grain(1, 10, 7, 6), grain(2, 5, 9, 5),
                                    grain(3, 7, 1, 3), grain(4, 8, 1, 6),  grain(1, 12, 1, 6)};
    auto open = grain(4, 8, 1, 6);
    open.touches_border = true;
    // The second of phase 1 is the first one now; one of that phase is gone, as is phase 3; phase 2
    // has lost a side, and phase 4 has reached the wall.
    const std::vector<Grain> after{grain(1, 10.5, 8, 6), grain(1, 1, 3, 6), grain(2, 5, 9, 4),
                                   open};
    const auto growth = measure_growth(before, after, {.duration = 2});
    ASSERT_EQ(growth.size(), 2U);
    EXPECT_EQ(growth[0].grain, before[0]);
    EXPECT_DOUBLE_EQ(growth[0].rate, -1);
    EXPECT_EQ(growth[1].grain, before[1]);
    EXPECT_DOUBLE_EQ(growth[1].rate, 0.5);
    EXPECT_NEAR(growth[1].error_rel, 0.5 / (pi / 3), 1e-15);
}

TEST(Grains, GrowthInFewFigures) {
    std::vector<GrainGrowth> growth(20);
    for (std::size_t i = 0; i < growth.size(); ++i) {
        growth[i].error_rel = static_cast<double>(20 - i) / 100;
    }
    const GrowthFigures figures = summarise(growth);
    EXPECT_EQ(figures.count, 20U);
    EXPECT_DOUBLE_EQ(figures.median_error_rel, 0.10);
    EXPECT_DOUBLE_EQ(figures.nine_tenths_error_rel, 0.18);
    EXPECT_DOUBLE_EQ(figures.worst_error_rel, 0.20);
    EXPECT_TRUE(std::isnan(summarise(std::vector<GrainGrowth>{}).median_error_rel));
    EXPECT_EQ(summarise(std::vector<Grain>{}).mean_area, 0);
}

TEST(Grains, BadOptionsAreRefused) {
    const std::vector<Grain> none;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, infinite, std::nan("")}) {
        EXPECT_THROW((void)measure_growth(none, none, {.duration = bad}), InputError);
        EXPECT_THROW((void)measure_growth(none, none, {.duration = 1, .multiplier = bad}),
                     InputError);
    }
}

} // namespace
} // namespace dsc::test::grains_test
