// SPDX-License-Identifier: MIT
// The spread of targets from vertex to vertex: which vertices are listed after a change, and the
// first target of a new vertex.
#include "dsc/complex/gather.h"
#include "dsc/passes/mesh/size_update.h"

#include "support/honeycomb.h"
#include "support/simulation_testing.h"

#include "dsc/base/verdict.h"
#include "dsc/complex/ranges.h"
#include "dsc/operations/edge_split.h"
#include "dsc/passes/work.h"
#include "dsc/sizes/sizes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dsc::size_update_test {
namespace {

class Told : public testing::Test {
protected:
    Told() {
        options.sizes.growth = 1.3;
        options.sizes.longest = 4;
        options.sizes.by_place = [this](const Point<double>& p, double, Phase) {
            return p.norm() < 0.1 ? at_origin : 4.0;
        };
        // All triangles get the exterior's phase, so that even the domain boundary is not on the
        // interface.
        for (const Triangle t : triangles(complex)) {
            complex.set_phase(t, exterior_phase);
        }
        measure_sizes(complex, options.sizes, options.edge_length, 0.0);
    }

    // The vertices that are listed for a visit after the target at the origin has changed.
    std::vector<std::uint32_t> told_of(double target) {
        at_origin = target;
        Work<double> work(complex, options);
        SizeUpdate<double> remeshing(work);
        Star<double> star;
        EXPECT_TRUE(gather(complex, Region{}, 0, star));
        EXPECT_NEAR(remeshing.follow(star), target, 1e-12);
        std::ranges::sort(work.resized);
        return work.resized;
    }

    double at_origin = 4;
    Complex<double> complex = test::honeycomb();
    Options<double> options = test::options_for<double>(1);
};

TEST_F(Told, AreAllNeighboursOfATargetThatFalls) {
    EXPECT_TRUE(told_of(4).empty());
    EXPECT_EQ(told_of(2).size(), 6U);
}

// The new target, with the growth over one edge, is below the targets of the neighbours by more
// than the slack; with the growth over two edges it would not be.
TEST_F(Told, AreNeighboursThatAFallReachesJustSo) { EXPECT_EQ(told_of(3.3).size(), 6U); }

TEST_F(Told, AreVisitedInTheNextPassOnceEach) {
    Work<double> work(complex, options);
    work.epoch = 1;
    work.resized = {3, 5, 3};
    activate_resized(work);
    EXPECT_EQ(work.active, (std::vector<std::uint32_t>{3, 5}));
    EXPECT_TRUE(work.resized.empty());
}

TEST_F(Told, AreThoseWhomItHeldDownWhenItRises) {
    at_origin = 1;
    measure_sizes(complex, options.sizes, options.edge_length, 0.0);
    const auto& field = size_field(complex);
    Star<double> star;
    ASSERT_TRUE(gather(complex, Region{}, 0, star));
    EXPECT_NEAR(field[Vertex{star.link[0]}].length, 1.3, 1e-6);
    EXPECT_EQ(told_of(1.5).size(), 6U);
}

TEST_F(Told, ANewVertexBeginsWithTheMeanOfTheEndsOfItsEdge) {
    auto& field = size_field(complex);
    const Edge edge = *edges(complex).begin();
    const auto [a, b] = complex.vertices_of(edge);
    field[a] = {.length = 1, .distance = 2};
    field[b] = {.length = 3, .distance = 8};
    const SplitResult split = edge_split(complex, edge);
    ASSERT_EQ(split.verdict, Verdict::legal);
    EXPECT_EQ(field[split.vertex].length, 2);
    EXPECT_EQ(field[split.vertex].distance, 5);
}

// The target of vertex 0 of a honeycomb that follows from its star.
class Followed : public testing::Test {
protected:
    double follow() {
        Work<double> work(complex, options);
        SizeUpdate<double> remeshing(work);
        Star<double> star;
        EXPECT_TRUE(gather(complex, Region{}, 0, star));
        const double length = remeshing.follow(star);
        told = work.resized.size();
        return length;
    }

    std::size_t told = 0;
    Complex<double> complex = test::honeycomb();
    Options<double> options = test::options_for<double>(1);
};

// The interface has reached the vertex.
TEST_F(Followed, AVertexOfTheInterfaceHasTheFinestTarget) {
    options.sizes.growth = 1.3;
    options.sizes.longest = 4;
    complex.set_phase(Triangle{triangle_of(complex.vertices[0].corner)}, 2);
    auto& field = size_field(complex);
    for (const Vertex v : vertices(complex)) {
        field[v] = {.length = 4};
    }
    EXPECT_EQ(follow(), 1);
    EXPECT_EQ(field[Vertex{0}].length, 1);
    EXPECT_EQ(told, 6U);
}

// The vertex's target does not change, but its distance from the interface does, on which other
// targets depend.
TEST_F(Followed, ADistanceThatHasChangedIsToldToAll) {
    options.sizes.growth = 1.3;
    options.sizes.longest = 4;
    options.sizes.by_distance = [](double) { return 4.0; };
    auto& field = size_field(complex);
    for (const Vertex v : vertices(complex)) {
        field[v] = {.length = 4, .distance = v.id == 0 ? 20.0 : 10.0};
    }
    EXPECT_EQ(follow(), 4);
    EXPECT_NEAR(field[Vertex{0}].distance, 10 + std::sqrt(3.0) / 2, 1e-12);
    EXPECT_EQ(told, 6U);
}

} // namespace
} // namespace dsc::size_update_test
