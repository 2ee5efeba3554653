// SPDX-License-Identifier: MIT
// The simplices, the algebra and the complex of reference/ on cases that can be checked by hand:
// the figures of the thesis.
#include "support/reference_testing.h"

#include "dsc/base/error.h"
#include "reference/complex/algebra.h"
#include "reference/operations/edge_collapse.h"

#include <limits>

namespace dsc::reference::reference_complex_test {
namespace {

// --- simplices and their sets [8.2]
// -----------------------------------------------------------------

TEST(ReferenceSimplex, IsItsVerticesInAnyOrder) {
    EXPECT_EQ(E(7, 3), E(3, 7));
    for (const auto& [a, b, c] :
         Triples{{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}}) {
        EXPECT_EQ(T(a, b, c), (TriangleKey{{1_v, 2_v, 3_v}}));
    }
}

TEST(ReferenceSimplex, SetsUniteSubtractAndIntersect) {
    SimplexSet a;
    a.insert(1_v);
    a.insert(E(1, 2));
    SimplexSet b;
    b.insert(E(2, 1));
    b.insert(T(1, 2, 3));
    EXPECT_EQ((a | b).size(), 3U);
    EXPECT_EQ((a - b).size(), 1U);
    EXPECT_TRUE((a - b).contains(1_v));
    EXPECT_EQ((a & b).size(), 1U);
    EXPECT_TRUE((a & b).contains(E(1, 2)));
}

// --- relations and operations [3.1]
// -----------------------------------------------------------------

TEST(ReferenceAlgebra, BoundaryAndFullBoundary) { // figures 3.3 and 3.4
    EXPECT_EQ(boundary(1_v).size(), 0U);
    EXPECT_EQ(boundary(E(1, 2)).vertices, (std::set{1_v, 2_v}));
    EXPECT_EQ(boundary(T(1, 2, 3)).edges, (std::set{E(1, 2), E(2, 3), E(1, 3)}));
    EXPECT_TRUE(boundary(T(1, 2, 3)).vertices.empty());
    EXPECT_EQ(full_boundary(1_v).size(), 0U);
    EXPECT_EQ(full_boundary(E(1, 2)), boundary(E(1, 2)));
    EXPECT_EQ(full_boundary(T(1, 2, 3)).size(), 6U);
    EXPECT_FALSE(full_boundary(T(1, 2, 3)).contains(T(1, 2, 3)));
}

TEST(ReferenceAlgebra, Star) { // figure 3.5
    const Complex K = fan();
    const SimplexSet all = star(K, 0_v);
    EXPECT_EQ(all.vertices, std::set{0_v});
    EXPECT_EQ(all.edges.size(), 6U);
    EXPECT_EQ(all.triangles.size(), 6U);
    EXPECT_FALSE(all.contains(E(1, 2)));
    const SimplexSet inner = star(K, E(0, 1));
    EXPECT_EQ(inner.triangles, (std::set{T(0, 1, 2), T(0, 1, 6)}));
    EXPECT_EQ(inner.size(), 3U);
    EXPECT_EQ(star(K, E(1, 2)).size(), 2U);
    EXPECT_EQ(star(K, T(0, 1, 2)).size(), 1U);
    EXPECT_EQ(star(K, closure(E(0, 1))), star(K, 0_v) | star(K, 1_v));
}

TEST(ReferenceAlgebra, Closure) { // figure 3.6
    EXPECT_EQ(closure(1_v).size(), 1U);
    EXPECT_EQ(closure(E(1, 2)).size(), 3U);
    EXPECT_EQ(closure(T(1, 2, 3)).size(), 7U);
    const Complex K = fan();
    EXPECT_EQ(closure(star(K, 0_v)).size(), 7U + 12U + 6U);
}

TEST(ReferenceAlgebra, Link) { // figure 3.7
    const Complex K = fan();
    const SimplexSet ring = link(K, 0_v);
    EXPECT_EQ(ring.vertices.size(), 6U);
    EXPECT_EQ(ring.edges.size(), 6U);
    EXPECT_TRUE(ring.contains(E(6, 1)));
    EXPECT_TRUE(ring.triangles.empty());
    EXPECT_EQ(link(K, 1_v).edges, (std::set{E(0, 2), E(0, 6)}));
    EXPECT_EQ(link(K, E(0, 1)).vertices, (std::set{2_v, 6_v}));
    EXPECT_EQ(link(K, E(0, 1)).size(), 2U);
    EXPECT_EQ(link(K, T(0, 1, 2)).size(), 0U);
    EXPECT_EQ(link(K, boundary(E(1, 4))), link(K, 1_v) | link(K, 4_v));
}

TEST(ReferenceAlgebra, SkeletonAndFilter) { // figures 3.8 and 3.9
    const SimplexSet set = closure(T(1, 2, 3));
    EXPECT_EQ(skeleton(1, set), full_boundary(T(1, 2, 3)));
    EXPECT_EQ(skeleton(0, set).size(), 3U);
    EXPECT_EQ(skeleton(2, set), set);
    EXPECT_EQ(filter(1, set), boundary(T(1, 2, 3)));
    EXPECT_EQ(filter(0, set).vertices, (std::set{1_v, 2_v, 3_v}));
    EXPECT_EQ(filter(2, set).triangles, std::set{T(1, 2, 3)});
}

// --- mesh functions [4.1], interface and boundaries [8.6]
// -------------------------------------------

TEST(ReferenceComplex, OrientationIsThatOfInsertion) {
    Complex K = make({{0, 0}, {1, 0}, {0, 1}}, {{0, 2, 1}}); // clockwise
    EXPECT_EQ(K.orientation(T(0, 1, 2)), 1);
    K.set_coord(2_v, {0, -1});
    EXPECT_EQ(K.orientation(T(0, 1, 2)), -1);
    EXPECT_EQ(validate(K).size(), 1U);
    K.set_coord(2_v, {3, 0});
    EXPECT_EQ(K.orientation(T(0, 1, 2)), 0);
}

TEST(ReferenceComplex, RemovesExactlyWhatIsNamedAndUsesNumbersAgain) {
    Complex K = fan();
    K.remove(T(0, 1, 2));
    EXPECT_FALSE(K.is_valid_simplex(T(0, 1, 2)));
    EXPECT_TRUE(K.is_valid_simplex(E(1, 2)));
    EXPECT_TRUE(K.triangles_at(E(1, 2)).empty());
    K.remove(star(K, 1_v));
    EXPECT_FALSE(K.is_valid_simplex(1_v));
    EXPECT_EQ(K.triangles().size(), 4U);
    EXPECT_EQ(K.insert(Point<double>(2, 0)), 1_v);
    EXPECT_TRUE(K.edges_at(1_v).empty());
}

TEST(ReferenceComplex, InterfaceAndBoundaries) {
    Complex K = fan({0}); // phase 1 at <0, 1, 2>, on the domain boundary: figure 8.3
    EXPECT_TRUE(K.is_interface(E(0, 1)));
    EXPECT_TRUE(K.is_interface(E(1, 2)));
    EXPECT_FALSE(K.is_interface(E(2, 3)));
    EXPECT_FALSE(K.is_interface(3_v));
    EXPECT_EQ(K.interface(), skeleton(1, closure(T(0, 1, 2))));
    EXPECT_FALSE(K.is_boundary(0_v));
    EXPECT_TRUE(K.is_boundary(4_v));
    EXPECT_TRUE(K.is_boundary(E(1, 2)));
    K.submesh_boundary_edges = {E(1, 2)}; // figure 8.2
    K.submesh_boundary_vertices = {1_v, 2_v};
    EXPECT_FALSE(K.is_boundary(E(1, 2)));
    EXPECT_FALSE(K.is_interface(E(1, 2)));
    EXPECT_TRUE(K.is_submesh_boundary(1_v));
    EXPECT_FALSE(K.is_submesh_boundary(E(0, 1)));
}

TEST(ReferenceComplex, BadInputIsNamed) {
    const Points points{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}};
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_THROW(make(points, {{0, 1, 5}}), InputError);
    EXPECT_THROW(make(points, {{0, 1, 3}}), InputError);
    EXPECT_THROW(make({{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 2}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}),
                 InputError);
    EXPECT_THROW(make({{0, 0}, {infinite, 0}, {0, 1}}, {{0, 1, 2}}), InputError);
    EXPECT_THROW(make_complex(points, Triples{{0, 1, 2}}, std::vector<Phase>{}), InputError);
}

TEST(ReferenceComplex, ArraysThereAndBack) {
    Complex K = grid(3, {0});
    EXPECT_EQ(edge_collapse(E(9, 10), K), Verdict::legal);
    const Arrays arrays = to_arrays(K);
    EXPECT_EQ(arrays.points.size(), 15U);
    EXPECT_EQ(print(make_complex(arrays.points, arrays.triangles, arrays.phases)), print(K));
}

} // namespace
} // namespace dsc::reference::reference_complex_test
