// SPDX-License-Identifier: MIT
// What a pass may cost, counted rather than timed: the stars that it looks at, how often it gathers
// them, and the passes that a sub-step takes. A fault of cost alone leaves the mesh as it is.
#include "support/honeycomb.h"
#include "support/simulation_testing.h"

#include "dsc/complex/circulate.h"
#include "dsc/passes/algorithm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace dsc::effort_test {
namespace {

using test::disc_complex;
using test::honeycomb;
using test::options_for;

// Counts how often a vertex is asked for: once for the centre of a star and once for each vertex of
// its link, whenever the star is gathered.
std::uint32_t count_question(const void* context, double /*x*/, double /*y*/) {
    ++*const_cast<std::uint64_t*>(static_cast<const std::uint64_t*>(context));
    return 0;
}

class OneStar : public testing::Test {
protected:
    OneStar() : work(complex, options) { work.epoch = 1; }

    Complex<double> complex = honeycomb();
    Options<double> options = options_for<double>(1);
    Work<double> work;
};

TEST_F(OneStar, AMoveWakesTheVertexAndItsLink) {
    work.movers.push_back({0, 0.01, 0.0});
    move_vertices(work);
    EXPECT_EQ(work.log.counts.moves, 1U);
    std::vector<std::uint32_t> woken = work.active;
    std::ranges::sort(woken);
    std::vector<std::uint32_t> star{0};
    for_each_corner(complex, Vertex{0}, [&](Corner c) { star.push_back(complex.vertex(next(c))); });
    std::ranges::sort(star);
    EXPECT_EQ(woken, star);
}

TEST_F(OneStar, IsLookedAtOnce) {
    work.movers.push_back({0, 0.01, 0.0});
    move_vertices(work);
    work.activate(0); // once more
    update_mesh(work);
    EXPECT_EQ(work.log.counts.examined, 7U);
    EXPECT_TRUE(work.active.empty());
}

TEST_F(OneStar, IsGatheredOnceForEachLook) {
    std::uint64_t questions = 0;
    work.submesh.region.kind = Region::Kind::places;
    work.submesh.region.place = &count_question;
    work.submesh.region.context = &questions;
    work.activate(0);
    for_each_corner(complex, Vertex{0}, [&](Corner c) { work.activate(complex.vertex(next(c))); });
    update_mesh(work);
    EXPECT_EQ(work.log.counts.examined, 7U);
    EXPECT_EQ(questions, 7U * work.log.counts.examined);
}

TEST_F(OneStar, NothingIsLookedAtWhereNothingChanged) {
    update_mesh(work);
    EXPECT_EQ(work.log.counts.examined, 0U);
}

// In a rigid motion all vertices arrive at once, and a second pass would find nothing to do.
TEST(Passes, AreAsManyAsVerticesNeedToArrive) {
    auto complex = disc_complex<double>(test::coarse);
    const auto options = options_for<double>(test::coarse);
    Simulation<double> simulation(complex, options);
    std::uint32_t passes = 0;
    std::uint32_t sub_steps = 0;
    for (int step = 0; step < 20; ++step) {
        const StepReport report =
            simulation.step(test::constant<double>(0.05 * test::coarse, 0), 0, 1);
        EXPECT_EQ(report.unreached, 0U);
        passes += report.passes;
        sub_steps += report.sub_steps;
    }
    EXPECT_EQ(sub_steps, 20U);
    EXPECT_EQ(passes, sub_steps);
}

} // namespace
} // namespace dsc::effort_test
