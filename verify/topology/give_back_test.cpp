// SPDX-License-Identifier: MIT
// Area taken by a change of topology is given back, up to the rounding of positions; and the area
// swept when the two ends of an edge merge is recorded.
#include "topology/give_back.h"

#include "support/random/scene.h"

#include "dsc/complex/ranges.h"
#include "dsc/passes/work.h"
#include "dsc/queries/locate.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "topology/junctions/merging.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace dsc::give_back_test {
namespace {

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

// Gives the triangle that contains the point to another phase; returns its area.
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
    const std::array before{phase_area(complex, 0), phase_area(complex, 1)};
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
    EXPECT_NEAR(phase_area(complex, 0), before[0], 4 * rounding);
    EXPECT_NEAR(phase_area(complex, 1), before[1], 4 * rounding);
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
            complex.vertices[v.id].flags |= fixed.size() % 2 == 0 ? vertex_locked : vertex_feature;
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

// The only vertex is at the very place of the event, so the weights have no scale.
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
    EXPECT_NEAR(phase_area(complex, 1), phase_area(before, 1) + 1e-5, 4 * rounding);
}

// --- two ends of a short edge that merge ---------------------------------------------------------

// v is (0.1, 0) and w the origin. If v moves to w, the triangle (v, p, q) becomes (w, p, q), a
// sliver of the given `height`; q is inside the phase, p is not.
Complex<double> with_sliver() {
    constexpr double height = 0.1;
    const std::vector<Point<double>> points{{0.1, 0}, {0, 0},    {0.5, 0.5 + height}, {1, 1},
                                            {0, -1},  {1, -0.5}, {-0.2, 1},           {-1, -0.3}};
    enum : std::uint32_t { v, w, q, p, e, f, g, i };
    const std::vector<std::array<std::uint32_t, 3>> triangles{{v, e, f}, {v, f, p}, {v, p, q},
                                                              {v, q, w}, {v, w, e}, {q, p, g},
                                                              {q, g, w}, {w, g, i}, {w, i, e}};
    return make_complex<double>(points, triangles, std::vector<Phase>(triangles.size(), 1));
}

TEST(Merging, LeavesEverythingInPlaceWhereAVertexIsLocked) {
    auto complex = with_sliver();
    complex.set_locked(Vertex{0}, true);
    Work<double> of{complex};
    EXPECT_FALSE(merge_ends(of.work, Vertex{0}, Vertex{1}, false).is_valid());
    EXPECT_EQ(complex.vertex_count(), 8U);
    EXPECT_EQ(validate(complex).problem, "");
}

// The curves from v to p and from v to f each sweep a triangle, with the base 0.1 on the x axis and
// the other end as apex.
TEST(Merging, NotesTheAreaThatCurvesSweep) {
    auto complex = with_sliver();
    constexpr std::array<Phase, 9> phases{1, 2, 3, 3, 1, 3, 3, 4, 1};
    for (std::uint32_t t = 0; t < 9; ++t) {
        complex.set_phase(Triangle{t + 1}, phases[t]);
    }
    Work<double> of{complex};
    ASSERT_EQ(merge_ends(of.work, Vertex{0}, Vertex{1}, false), Vertex{1});
    EXPECT_NEAR(of.work.swept, 0.1 * 1 / 2 + 0.1 * 0.5 / 2, 1e-12);
}

} // namespace
} // namespace dsc::give_back_test
