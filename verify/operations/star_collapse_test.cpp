// SPDX-License-Identifier: MIT
// The fast guard of the mesh update agrees with the guard of the edge collapse, for every star.
#include "support/small_meshes.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/gather.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_flip.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace dsc::star_collapse_test {
namespace {

// Grids whose diagonals are flipped at random: stars of all degrees, many of them not convex.
Complex<double> tangled(unsigned seed) {
    auto complex = test::grid<double>(10, 0.19, seed);
    std::mt19937 random(seed);
    for (int i = 0; i < 400; ++i) {
        const auto number = static_cast<std::uint32_t>(random());
        const std::uint32_t t = 1 + number % (complex.triangle_bound() - 1);
        (void)edge_flip(complex, complex.edge(corner_of(t, number % 3)));
    }
    return complex;
}

TEST(StarCollapse, IsGuardedAsAnyCollapse) {
    std::map<Verdict, int> verdicts;
    Star<double> star;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        const auto complex = tangled(seed);
        for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
            if (!gather(complex, Region{}, v, star) || !star.closed || star.size < 4) {
                continue;
            }
            for (std::uint32_t i = 0; i < star.size; ++i) {
                const Verdict usual =
                    edge_collapse_guard(complex, Region{}, prev(star.corner[i]),
                                        rewire::Vanishing::next, JunctionRule::kept);
                // For a vertex inside a phase whose whole star is owned, inversion is the only
                // possible refusal.
                const bool is_plain = usual == Verdict::legal || usual == Verdict::inverts;
                if (is_plain) {
                    EXPECT_EQ(star_collapse_guard(complex, star, i), usual)
                        << "seed " << seed << ", vertex " << v << ", incident_edge " << i;
                    ++verdicts[usual];
                }
            }
        }
    }
    EXPECT_GT(verdicts[Verdict::legal], 1000);
    EXPECT_GT(verdicts[Verdict::inverts], 1000);
}

TEST(StarCollapse, LeavesLockedVertices) {
    auto complex = test::hexagon<double>();
    complex.set_locked(Vertex{0}, true);
    Star<double> star;
    ASSERT_TRUE(gather(complex, Region{}, 0, star));
    EXPECT_EQ(star_collapse_guard(complex, star, 0), Verdict::locked);
}

} // namespace
} // namespace dsc::star_collapse_test
