// SPDX-License-Identifier: MIT
// Area that a change of topology takes is given back, to the rounding of the positions.
#include "topology/give_back.h"

#include "support/random/scene.h"
#include "support/topology/changing.h"
#include "support/topology/topology_testing.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/complex/ranges.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/parallel/parallel.h"
#include "dsc/queries/locate.h"
#include "dsc/queries/validate.h"
#include "geometric_flows/curvature_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

namespace dsc::give_back_test {
namespace {

template <class Real>
std::map<Phase, double> areas_of(const Complex<Real>& complex) {
    std::map<Phase, double> areas;
    for (const Triangle t : triangles(complex)) {
        const auto v = complex.vertices_of(t);
        areas[complex.phase(t)] += area<double>(complex.position(v[0]).template cast<double>(),
                                                complex.position(v[1]).template cast<double>(),
                                                complex.position(v[2]).template cast<double>());
    }
    return areas;
}

template <class Real>
struct Work {
    Complex<Real>& complex;
    TopologyOptions<Real> options{.rule = Topology::change, .gives_back_area = true};
    std::vector<Event> events = {};
    TopologyWork<Real> work{.complex = complex,
                            .options = options,
                            .edge_length = Real(0.02),
                            .time = 0,
                            .events = events};
};

// The triangle that contains the point changes hands.
template <class Real>
double take(TopologyWork<Real>& work, const Point<Real>& place, Phase phase) {
    const Triangle t = locate(work.complex, place).triangle;
    const double area = static_cast<double>(doubled_area(work.complex, t)) / 2;
    give(work, t, phase);
    return area;
}

template <class Real>
class GiveBackTyped : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(GiveBackTyped, Reals);

TYPED_TEST(GiveBackTyped, LeavesBothPhasesTheirAreas) {
    using Real = TypeParam;
    auto complex = test::disc_complex<Real>(0.02);
    const auto before = areas_of(complex);
    Work<Real> of{complex};
    double taken = take<Real>(of.work, {Real(0.745), Real(0.5)}, exterior_phase);
    taken += take<Real>(of.work, {Real(0.5), Real(0.745)}, exterior_phase);
    taken -= take<Real>(of.work, {Real(0.3), Real(0.29)}, 1);
    ASSERT_GT(std::abs(taken), 1e-6);
    const AreaAccount account = give_back(of.work);
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_TRUE(of.work.transfers.empty());
    EXPECT_GT(account.given_back, 1e-4);
    const double rounding = std::is_same_v<Real, double> ? 1e-16 : 1e-8;
    EXPECT_LT(account.owed, rounding);
    EXPECT_NEAR(areas_of(complex).at(1), before.at(1), 4 * rounding);
    EXPECT_NEAR(areas_of(complex).at(0), before.at(0), 4 * rounding);
}

TEST(GiveBack, MovesNothingByMoreThanATenthOfAnEdge) {
    auto complex = test::disc_complex<double>(0.02);
    const auto before = complex;
    Work<double> of{complex};
    take<double>(of.work, {0.745, 0.5}, exterior_phase);
    (void)give_back(of.work);
    double farthest = 0;
    for (const Vertex v : vertices(complex)) {
        const double way = (complex.position(v) - before.position(v)).norm();
        farthest = std::max(farthest, way);
        if ((before.position(v) - Point<double>(0.745, 0.5)).norm() > 0.2) {
            EXPECT_EQ(way, 0);
        }
    }
    EXPECT_GT(farthest, 1e-4);
    EXPECT_LT(farthest, 0.1 * 0.02 * (1 + 1e-12));
}

TEST(GiveBack, TellsWhatIsOwedToAPhaseThatHasVanished) {
    auto complex = test::disc_complex<double>(0.02);
    const Triangle t = locate<double>(complex, {0.5, 0.5}).triangle;
    complex.set_phase(t, 7);
    Work<double> of{complex};
    const double taken = take<double>(of.work, centroid(complex, t), 1);
    const AreaAccount account = give_back(of.work);
    EXPECT_EQ(account.given_back, 0);
    EXPECT_DOUBLE_EQ(account.owed, taken);
}

TEST(GiveBack, LeavesLockedVerticesAndCornersWhereTheyAre) {
    auto complex = test::disc_complex<double>(0.02);
    std::vector<Vertex> fixed;
    for (const Vertex v : vertices(complex)) {
        if (is_interface(complex, v) && complex.position(v).x() > 0.7) {
            complex.vertices[v.id].flags |= fixed.size() % 2 == 0 ? vertex_locked : vertex_corner;
            fixed.push_back(v);
        }
    }
    const auto before = complex;
    Work<double> of{complex};
    of.work.transfers.push_back({1, exterior_phase, 1e-5, {0.74, 0.5}, {}});
    const AreaAccount account = give_back(of.work);
    EXPECT_NEAR(account.given_back, 1e-5, 1e-15);
    ASSERT_GT(fixed.size(), 10U);
    for (const Vertex v : fixed) {
        EXPECT_EQ(complex.position(v), before.position(v));
    }
}

// No other vertex is farther away, by which the weights could be measured.
TYPED_TEST(GiveBackTyped, MovesASingleVertexThatLiesAtTheVeryPlace) {
    using Real = TypeParam;
    auto complex = test::disc_complex<Real>(0.02);
    const auto before = complex;
    Vertex single{};
    for (const Vertex v : vertices(complex)) {
        if (is_interface(complex, v) && complex.position(v).x() > Real(0.74)) {
            single = v;
        }
        complex.vertices[v.id].flags |= vertex_locked;
    }
    complex.vertices[single.id].flags &= ~vertex_locked;
    Work<Real> of{complex};
    const Point<double> place = complex.position(single).template cast<double>();
    of.work.transfers.push_back({1, exterior_phase, 1e-5, place, {}});
    const AreaAccount account = give_back(of.work);
    EXPECT_EQ(validate(complex).problem, "");
    const double rounding = std::is_same_v<Real, double> ? 1e-16 : 1e-8;
    EXPECT_NEAR(account.given_back, 1e-5, rounding);
    EXPECT_LT(account.owed, rounding);
    EXPECT_GT((complex.position(single) - before.position(single)).norm(), Real(1e-4));
    EXPECT_NEAR(areas_of(complex).at(1), areas_of(before).at(1) + 1e-5, 4 * rounding);
}

TEST(GiveBack, DoesNothingUnlessItIsAskedFor) {
    auto complex = test::disc_complex<double>(0.02);
    Work<double> of{complex, {.rule = Topology::change}};
    take<double>(of.work, {0.745, 0.5}, exterior_phase);
    EXPECT_TRUE(of.work.transfers.empty());
}

struct Course {
    AreaAccount account;
    double worst = 0; ///< difference of a phase's area before and after a change of topology
    std::size_t events = 0;
};

// Grains move by their curvature; the topology changes between the steps, so that the areas before
// and after can be compared.
Course change_grains(bool gives_back) {
    constexpr double h = 0.03;
    auto complex = test::random_grains(40, h, 5);
    test::ChangingOptions<double> options;
    options.edge_length = h;
    options.interface.corner_degrees = 180;
    test::ChangingSimulation<double> simulation(complex, options);
    Course course;
    for (int i = 0; i < 60; ++i) {
        simulation.step(curvature_flow<double>(), 0, 0.2 * h * h);
        std::vector<Suspect<double>> suspects;
        for (const Vertex v : vertices(complex)) {
            const Point<double> p = complex.position(v);
            suspects.push_back({p.x(), p.y(), v.id, true, true, true, true});
        }
        const auto before = areas_of(complex);
        std::vector<Event> events;
        const TopologyOptions<double> topology{.rule = Topology::change,
                                               .gives_back_area = gives_back};
        const AreaAccount account =
            change_topology<double>(complex, topology, h, suspects, 0, events);
        EXPECT_EQ(validate(complex).problem, "");
        auto after = areas_of(complex);
        double all = 0;
        for (const auto& [phase, area] : before) {
            all += std::abs(after[phase] - area) / 2;
        }
        EXPECT_NEAR(all, account.owed, gives_back ? 1e-14 : 1);
        course.worst = std::max(course.worst, all);
        course.account += account;
        course.events += events.size();
    }
    return course;
}

TEST(GiveBack, KeepsTheAreasOfGrainsThatExchangeTheirNeighbours) {
    const Course lost = change_grains(false);
    const Course kept = change_grains(true);
    ASSERT_GT(kept.events, 10U);
    EXPECT_GT(lost.worst, 1e-4);
    EXPECT_EQ(lost.account.given_back + lost.account.owed, 0);
    EXPECT_GT(kept.account.given_back, 1e-4);
}

} // namespace
} // namespace dsc::give_back_test
