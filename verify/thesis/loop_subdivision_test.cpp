// SPDX-License-Identifier: MIT
// Loop subdivision on hand-sized complexes: each verdict, each result. A refused operation changes
// no byte; every result is validated.
#include "thesis/loop_subdivision.h"

#include "support/operations_testing.h"
#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsc::test::loop_subdivision_test {
namespace {

template <class Real>
class LoopSubdivision : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(LoopSubdivision, Reals);

TYPED_TEST(LoopSubdivision, IsRefused) {
    const auto subdivide = [](Triangle t) {
        return [t](const auto& submesh) { return loop_subdivision(submesh, t).verdict; };
    };
    auto K = hexagon<TypeParam>();
    expect_refused(K, Verdict::not_a_simplex, subdivide(Triangle{}));
    expect_refused(K, Verdict::not_a_simplex, subdivide(Triangle{border_triangle}));
    expect_refused(K, Verdict::not_a_simplex, subdivide(Triangle{7}));
    // Triangle 1 is (0, 1, 2); its neighbours are (0, 6, 1) and (0, 2, 3).
    expect_refused(K, Verdict::on_submesh_boundary, subdivide(Triangle{1}), {1, 1, 0, 1, 1, 1, 1});
    expect_refused(K, Verdict::on_submesh_boundary, subdivide(Triangle{1}), {1, 1, 1, 0, 1, 1, 1});
    expect_refused(K, Verdict::on_submesh_boundary, subdivide(Triangle{1}), {1, 1, 1, 1, 1, 1, 0});
    EXPECT_EQ(verdict_with_ids(K, 2, 9, subdivide(Triangle{1})), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 9, 4, subdivide(Triangle{1})), Verdict::out_of_ids);
    EXPECT_EQ(verdict_with_ids(K, 3, 5, subdivide(Triangle{1})), Verdict::legal);
    K.set_phase(Triangle{2}, 1);
    expect_refused(K, Verdict::on_interface, subdivide(Triangle{1}));
    expect_refused(K, Verdict::on_interface, subdivide(Triangle{2}));
    // A vertex on the interface is no reason.
    EXPECT_EQ(loop_subdivision(K, Triangle{4}).verdict, Verdict::legal);
    expect_valid(K);
    // The domain boundary of another phase than the exterior is interface (figure 8.3).
    auto inner = build<TypeParam>({{0, 0}, {2, 0}, {0, 2}}, {{0, 1, 2}}, {1});
    expect_refused(inner, Verdict::on_interface, subdivide(Triangle{1}));
}

TYPED_TEST(LoopSubdivision, OfTheSmallestTriangleInverts) {
    // The midpoint of two neighbouring numbers is one of them.
    const TypeParam one = 1;
    const TypeParam after = std::nextafter(one, TypeParam(2));
    auto K = build<TypeParam>({{one, one}, {after, one}, {one, after}}, {{0, 1, 2}}, {0});
    expect_refused(K, Verdict::inverts, [](const auto& submesh) {
        return loop_subdivision(submesh, Triangle{1}).verdict;
    });
}

} // namespace
} // namespace dsc::test::loop_subdivision_test
