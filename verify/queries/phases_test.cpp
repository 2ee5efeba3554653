// SPDX-License-Identifier: MIT
// What is derived from phases (thesis, section 8.6), against its definition on sets of simplices.
#include "dsc/queries/phases.h"

#include "support/small_meshes.h"

#include "dsc/base/types.h"
#include "thesis/sets/algebra.h"
#include "thesis/sets/mesh_functions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dsc::phases_test {
namespace {

using test::grid;

template <class Real>
class DerivedFromPhases : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(DerivedFromPhases, Reals);

// Figure 8.3 of the thesis: the interface runs between phases, and along the domain boundary of
// what is inside.
TYPED_TEST(DerivedFromPhases, InterfaceAndBoundary) {
    auto complex = grid<TypeParam>(8, 0.15, 6, 2.5);
    complex.set_phase(Triangle{1}, 2); // touches the domain boundary at (0, 0)
    const SimplexSet interface = interface_of(complex);
    const SimplexSet all = all_simplices(complex);
    EXPECT_TRUE(interface.triangles().empty());
    SimplexSet expected;
    for (const Edge e : all.edges()) {
        const SimplexSet around = star(complex, e);
        const Phase first = phase(complex, around.triangles().front());
        const Phase last = phase(complex, around.triangles().back());
        const bool lone = around.triangles().size() == 1;
        EXPECT_EQ(is_boundary(complex, e), lone);
        EXPECT_EQ(is_interface(complex, e), lone ? first != 0 : first != last);
        if (lone ? first != 0 : first != last) {
            expected.insert(closure(complex, e));
        }
    }
    EXPECT_EQ(interface, expected);
    EXPECT_GT(interface.edges().size(), 10U);
    for (const Vertex v : all.vertices()) {
        EXPECT_EQ(is_interface(complex, v), interface.contains(v));
        const auto p = complex.position(v);
        EXPECT_EQ(is_boundary(complex, v), p.x() == 0 || p.y() == 0 || p.x() == 8 || p.y() == 8);
    }
    for (const Triangle t : all.triangles()) {
        const auto edges = complex.edges_of(t);
        EXPECT_EQ(is_interface(complex, t), std::any_of(edges.begin(), edges.end(), [&](Edge e) {
                      return interface.contains(e);
                  }));
        EXPECT_EQ(is_boundary(complex, t), std::any_of(edges.begin(), edges.end(), [&](Edge e) {
                      return is_boundary(complex, e);
                  }));
        EXPECT_EQ(orientation(complex, t), 1);
    }
    EXPECT_TRUE(is_interface(complex, Vertex{0})) << "phase 2 meets the domain boundary there";
    EXPECT_EQ(phases(complex), (std::vector<Phase>{0, 1, 2}));
    double total = 0;
    for (const Phase p : phases(complex)) {
        total += phase_area(complex, p);
    }
    const double tolerance = sizeof(TypeParam) == sizeof(double) ? 1e-12 : 1e-4;
    EXPECT_NEAR(total, 64, tolerance);
    EXPECT_NEAR(phase_area(complex, 2), 0.5, 0.2);
    EXPECT_EQ(phase_area(complex, 17), 0);
}

} // namespace
} // namespace dsc::phases_test
