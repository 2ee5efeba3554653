// SPDX-License-Identifier: MIT
// What lets vertices of the interface arrive that a movement alone does not.
#include "dsc3/passes/clearance.h"
#include "dsc3/passes/pending_at_targets.h"
#include "dsc3/space_testing.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dsc3::test::arrival_test {
namespace {

// The worst quality of the tets at a vertex if all pending ones were at their targets.
double worst_at_targets(PassState& state, std::uint32_t v) {
    const PendingAtTargets at_targets(state);
    Star star;
    gather(state.complex, v, star);
    double worst = 1;
    for (const Corner corner : star.corners) {
        worst = std::min(worst, double(quality_of(state.complex, tet_of(corner))));
    }
    return worst;
}

// The target of a vertex of the interface is beyond a free neighbour, which can move on.
TEST(Arrival3, FreeVerticesMakeWay) {
    constexpr double h = 0.1;
    Complex complex = initial_complex({}, {{ball({0.5, 0.5, 0.5}, 0.25), 1}}, {.edge_length = h});
    const Options options{.edge_length = h};
    Team team;
    PassState state{complex, options, team};
    state.grow();
    std::uint32_t blocked = 0;
    std::uint32_t freed = 0;
    Star star;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        if (!complex.is_alive(Vertex{v}) || !complex.is_interface(Vertex{v})) {
            continue;
        }
        gather(complex, v, star);
        const auto& tet = complex.tets[tet_of(star.corners[0])];
        for (const std::uint32_t w : tet.v) {
            if (complex.is_interface(Vertex{w}) || complex.is_boundary(Vertex{w})) {
                continue;
            }
            const Point before = complex.at(w);
            state.targets[v] = complex.at(v) + 1.02 * (before - complex.at(v));
            state.pending = {v};
            ASSERT_LT(worst_at_targets(state, w), 0);
            ++blocked;
            make_way(state);
            EXPECT_EQ(complex.at(w), before) << "it only gets a target";
            freed += worst_at_targets(state, w) > 0 ? 1U : 0U;
        }
    }
    EXPECT_GT(blocked, 50U);
    EXPECT_GT(freed, blocked / 2) << "in many stars, no place lets all tets be positive";
}

} // namespace
} // namespace dsc3::test::arrival_test
