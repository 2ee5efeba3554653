// SPDX-License-Identifier: MIT
// Areas, lengths, components and holes of phases on a grid of squares.
#include "measures/phases.h"
#include "support/small_meshes.h"

#include "dsc/complex/ranges.h"

#include <gtest/gtest.h>

#include <tuple>

namespace dsc::test::phases_test {
namespace {

using namespace dsc::scenes;

template <class Real>
class Phases : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Phases, Reals);

// Phase 3 fills the three lowest rows of 8 x 8 squares but for one square of phase 0 in them; phase
// 1 is a square of 2 x 2 on top of these, and another by itself; the rest is phase 0.
template <class Real>
Complex<Real> shelves() {
    auto K = grid<Real>(8);
    for (const Triangle t : triangles(K)) {
        const std::uint32_t i = (t.id - 1) / 2 % 8;
        const std::uint32_t j = (t.id - 1) / 16;
        const bool in_one = (i >= 1 && i < 3 && j >= 3 && j < 5) || (i == 5 && j == 6);
        K.set_phase(t, in_one ? 1 : j < 3 && !(i == 4 && j == 1) ? 3 : 0);
    }
    return K;
}

TYPED_TEST(Phases, AreaPerimeterBoundaryComponentsAndHoles) {
    const PhaseReport report = measure_phases(shelves<TypeParam>());
    ASSERT_EQ(report.phases.size(), 3U);
    const auto& [exterior, one, three] =
        std::tie(report.phases[0], report.phases[1], report.phases[2]);
    EXPECT_EQ(exterior.phase, 0U);
    EXPECT_EQ(one.phase, 1U);
    EXPECT_EQ(three.phase, 3U);
    EXPECT_DOUBLE_EQ(one.area, 5);
    EXPECT_DOUBLE_EQ(three.area, 23);
    EXPECT_DOUBLE_EQ(exterior.area, 64 - 28);
    EXPECT_DOUBLE_EQ(one.perimeter, 12);
    EXPECT_DOUBLE_EQ(one.boundary, 0);
    EXPECT_DOUBLE_EQ(three.perimeter, 12);
    EXPECT_DOUBLE_EQ(three.boundary, 14);
    EXPECT_DOUBLE_EQ(exterior.perimeter, 20);
    EXPECT_DOUBLE_EQ(exterior.boundary, 18);
    EXPECT_EQ(one.components, 2U);
    EXPECT_EQ(one.holes, 0U);
    EXPECT_EQ(three.components, 1U);
    EXPECT_EQ(three.holes, 1U);
    EXPECT_EQ(exterior.components, 2U);
    EXPECT_EQ(exterior.holes, 1U);
}

TYPED_TEST(Phases, LengthOfTheInterfaceOfEachPair) {
    const PhaseReport report = measure_phases(shelves<TypeParam>());
    ASSERT_EQ(report.pairs.size(), 3U);
    const auto expect = [&](std::size_t i, Phase one, Phase other, double length) {
        EXPECT_EQ(report.pairs[i].one, one);
        EXPECT_EQ(report.pairs[i].other, other);
        EXPECT_DOUBLE_EQ(report.pairs[i].length, length);
    };
    expect(0, 0, 1, 10);
    expect(1, 0, 3, 10);
    expect(2, 1, 3, 2);
}

} // namespace
} // namespace dsc::test::phases_test
