// SPDX-License-Identifier: MIT
// The rules of movement and mesh update, each on a star to which only that rule applies; and the
// cost of a pass: visited stars, how often they are gathered, and the passes of a sub-step.
#include "support/honeycomb.h"
#include "support/simulation_testing.h"
#include "support/small_meshes.h"

#include "dsc/algorithm/executor.h"
#include "dsc/base/verdict.h"
#include "dsc/complex/circulate.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/algorithm.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace dsc::one_star_test {
namespace {

using test::disc_complex;
using test::honeycomb;
using test::options_for;

// A region of everything except a disc about the point `context`.
std::uint32_t is_near(const void* context, double x, double y) {
    const auto& centre = *static_cast<const Point<double>*>(context);
    return (Point<double>(x, y) - centre).norm() < 0.1 ? 1 : 0;
}

// Runs a pass that visits vertex 0 of a honeycomb.
class AStar : public testing::Test {
protected:
    AStar() : work(complex, options) { work.epoch = 1; }

    void leave_out(const Point<double>& centre) {
        hole = centre;
        work.submesh.region.kind = Region::Kind::places;
        work.submesh.region.place = &is_near;
        work.submesh.region.context = &hole;
    }
    void update() {
        work.activate(0);
        update_mesh(work);
    }
    bool is_deferred(DeferredKind kind) const {
        return std::ranges::any_of(work.deferred.entries, [&](const Deferred<double>& one) {
            return one.kind == kind && one.vertex == 0;
        });
    }

    Complex<double> complex = honeycomb();
    Options<double> options = options_for<double>(1);
    Work<double> work;
    Point<double> hole;
};

TEST_F(AStar, IsSmoothedToTheMiddle) {
    complex.set_position(Vertex{0}, {0.5, 0.1});
    update();
    EXPECT_EQ(work.log.counts.smoothed, 1U);
    EXPECT_LT(complex.position(Vertex{0}).norm(), 0.3);
}

TEST_F(AStar, IsNotSmoothedOutOfItsSubmesh) {
    complex.set_position(Vertex{0}, {0.5, 0.1});
    options.phases.smooth_quality = 0.9;
    leave_out({0, 0});
    update();
    EXPECT_GE((complex.position(Vertex{0}) - hole).norm(), 0.1);
    EXPECT_TRUE(is_deferred(DeferredKind::star));
}

TEST_F(AStar, OfPoorTrianglesIsCollapsed) {
    options.phases.smooth_quality = 0;
    options.phases.shortest = 0; // poor quality is the only reason left
    options.phases.crowded = 0;
    const Vertex far{complex.vertex(next(complex.vertices[0].corner))};
    const SplitResult split = edge_split(complex, complex.find_edge(Vertex{0}, far),
                                         Point<double>(0.1 * complex.position(far)));
    ASSERT_EQ(split.verdict, Verdict::legal);
    update();
    EXPECT_EQ(work.log.counts.collapses, 1U);
}

TEST_F(AStar, MovesNoVertexOutOfItsSubmesh) {
    leave_out({0.3, 0});
    work.moving_vertices.push_back({0, 0.3, 0});
    move_vertices(work);
    EXPECT_EQ(complex.position(Vertex{0}), Point<double>(0, 0));
    EXPECT_TRUE(work.moving_vertices.empty());
    EXPECT_TRUE(is_deferred(DeferredKind::moving_vertex));
}

TEST_F(AStar, ThatVanishesOnItsWayHasNowhereToArrive) {
    const Edge incident_edge =
        complex.find_edge(Vertex{0}, Vertex{complex.vertex(next(complex.vertices[0].corner))});
    ASSERT_EQ(edge_collapse(complex, incident_edge, Vertex{0}), Verdict::legal);
    work.moving_vertices.push_back({0, 0.3, 0});
    EXPECT_EQ(give_up_moving_vertices(work), 0U);
    EXPECT_TRUE(work.moving_vertices.empty());
}

// --- effort: counted rather than timed -----------------------------------------------------------
// A fault that only increases the cost does not change the mesh, so the cost is counted.

// Counts the queries of ownership: one for the centre of a star and one for each vertex of its
// link, whenever the star is gathered.
std::uint32_t count_question(const void* context, double /*x*/, double /*y*/) {
    ++*const_cast<std::uint64_t*>(static_cast<const std::uint64_t*>(context));
    return 0;
}

TEST_F(AStar, AMoveWakesTheVertexAndItsLink) {
    work.moving_vertices.push_back({0, 0.01, 0.0});
    move_vertices(work);
    EXPECT_EQ(work.log.counts.moves, 1U);
    std::vector<std::uint32_t> woken = work.active;
    std::ranges::sort(woken);
    std::vector<std::uint32_t> star{0};
    for_each_corner(complex, Vertex{0}, [&](Corner c) { star.push_back(complex.vertex(next(c))); });
    std::ranges::sort(star);
    EXPECT_EQ(woken, star);
}

TEST_F(AStar, IsLookedAtOnce) {
    work.moving_vertices.push_back({0, 0.01, 0.0});
    move_vertices(work);
    work.activate(0); // once more
    update_mesh(work);
    EXPECT_EQ(work.log.counts.examined, 7U);
    EXPECT_TRUE(work.active.empty());
}

TEST_F(AStar, IsGatheredOnceForEachLook) {
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

TEST_F(AStar, NothingIsLookedAtWhereNothingChanged) {
    update_mesh(work);
    EXPECT_EQ(work.log.counts.examined, 0U);
}

// In a rigid motion all vertices arrive in the first pass, so there must be no second one.
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

// --- sides, and stars that are kept --------------------------------------------------------------

// Four by four squares; (i, j) has the id 5 j + i.
TEST(Boundaries, AreLeftByNoVertex) {
    auto complex = test::grid<double>(4);
    auto options = options_for<double>(1);
    Work<double> work(complex, options);
    work.epoch = 1;
    work.moving_vertices.push_back({2, 2.3, -0.7}); // in the middle of the lower side
    work.moving_vertices.push_back({0, -0.5, 0.2}); // a corner of the domain
    work.moving_vertices.push_back({10, 0.4, 2.2}); // in the middle of the left side
    move_vertices(work);
    EXPECT_EQ(complex.position(Vertex{2}), Point<double>(2.3, 0));
    EXPECT_EQ(complex.position(Vertex{0}), Point<double>(0, 0));
    EXPECT_EQ(complex.position(Vertex{10}), Point<double>(0, 2.2));
}

// A cached star gives movement the same data as a new walk, wherever its vertices are by then; an
// edit, which changes the centre's stamp, invalidates it.
TEST(CachedStars, AreReadUntilTheyChange) {
    auto complex = test::grid<double>(4);
    const auto options = options_for<double>(1);
    Work<double> work(complex, options);
    work.epoch = 1;
    ASSERT_TRUE(gather(complex, Region{}, 12, work.star));
    work.stars = {cache_star(complex, work.star, {})};
    complex.set_position(Vertex{11}, {1.9, 1.2});
    Star<double> walked;
    ASSERT_TRUE(gather(complex, Region{}, 12, walked));
    gather_cached(complex, Region{}, work.stars[0], work.star);
    ASSERT_EQ(work.star.size, walked.size);
    for (std::uint32_t i = 0; i < walked.padded(); ++i) {
        EXPECT_EQ(work.star.x[i], walked.x[i]);
        EXPECT_EQ(work.star.y[i], walked.y[i]);
        EXPECT_EQ(work.star.x_next[i], walked.x_next[i]);
        EXPECT_EQ(work.star.y_next[i], walked.y_next[i]);
    }
    // The link of the vertex reaches from 1 to 3.
    for (const auto kind : {Region::Kind::upright, Region::Kind::box}) {
        for (const auto& [low, high, owned] :
             {std::tuple(1.0, 3.5, true), {1.01, 3.5, false}, {1.0, 3.0, false}}) {
            gather_cached(complex, {.kind = kind, .low = low, .high = high}, work.stars[0],
                          work.star);
            EXPECT_EQ(work.star.owned, owned) << low << " to " << high;
        }
    }
    work.interface = {12};
    work.trajectory.positions = {complex.position(Vertex{12})};
    work.trajectory.targets = {Point<double>(2.1, 2)};
    work.trajectory.held = {0};
    collect_moving_vertices(work);
    EXPECT_EQ(work.moving_vertices.back().star, 0U);
    work.activate(12);
    collect_moving_vertices(work);
    EXPECT_EQ(work.moving_vertices.back().star, no_id);
}

} // namespace
} // namespace dsc::one_star_test
