// SPDX-License-Identifier: MIT
// Ranges over the simplices in use, on meshes with free ids in front, in the middle and at the end.
#include "dsc/complex/ranges.h"

#include "support/small_meshes.h"

#include "dsc/base/verdict.h"
#include "dsc/operations/edge_split.h"
#include "thesis/sets/algebra.h"
#include "thesis/sets/insertion_removal.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dsc::ranges_test {
namespace {

using test::grid;
using test::hexagon;

template <class Range>
std::vector<std::uint32_t> ids(const Range& range) {
    std::vector<std::uint32_t> result;
    for (const auto handle : range) {
        result.push_back(handle.id);
    }
    return result;
}
using Ids = std::vector<std::uint32_t>;

template <class Real>
class Ranges : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Ranges, Reals);

// The phases of a hexagon: 0, 1, 2, 0, 1, 2.
TYPED_TEST(Ranges, OfAPhaseMeetItsTrianglesAlone) {
    auto complex = hexagon<TypeParam>();
    for (const Triangle t : triangles(complex)) {
        complex.set_phase(t, (t.id - 1) % 3);
    }
    EXPECT_EQ(ids(triangles(complex, 0)), (Ids{1, 4}));
    EXPECT_EQ(ids(triangles(complex, 1)), (Ids{2, 5}));
    EXPECT_EQ(ids(triangles(complex, 2)), (Ids{3, 6}));
    EXPECT_TRUE(triangles(complex, 3).empty());
    remove(complex, SimplexSet({}, {}, {Triangle{1}, Triangle{6}}));
    EXPECT_EQ(ids(triangles(complex, 0)), (Ids{4}));
    EXPECT_EQ(ids(triangles(complex, 2)), (Ids{3}));
}

TYPED_TEST(Ranges, AgreeWithTheSetsOfALargerMesh) {
    auto complex = grid<TypeParam>(8, 0.15, 3, 3);
    // The first id, one between others, and the last; and a vertex without triangles.
    remove(complex, SimplexSet({Vertex{0}, Vertex{40}, Vertex{80}}, {}, {}));
    insert_vertex(complex, Point<TypeParam>(20, 20));
    const SimplexSet all = all_simplices(complex);
    EXPECT_TRUE(std::ranges::equal(vertices(complex), all.vertices()));
    EXPECT_TRUE(std::ranges::equal(edges(complex), all.edges()));
    EXPECT_TRUE(std::ranges::equal(triangles(complex), all.triangles()));
    for (const Vertex v : vertices(complex)) {
        std::vector<Triangle> star_of(star_triangles(complex, v).begin(),
                                      star_triangles(complex, v).end());
        std::ranges::sort(star_of);
        EXPECT_EQ(star_of, star(complex, v).triangles());
        std::vector<Vertex> link_of(link_vertices(complex, v).begin(),
                                    link_vertices(complex, v).end());
        std::ranges::sort(link_of);
        EXPECT_EQ(link_of, link(complex, v).vertices());
    }
}

TYPED_TEST(Ranges, OfAStarAndALinkGoRoundCounterClockwise) {
    auto complex = hexagon<TypeParam>();
    complex.vertices[0].corner = corner_of(3, 0);
    EXPECT_EQ(ids(star_triangles(complex, Vertex{0})), (Ids{3, 4, 5, 6, 1, 2}));
    EXPECT_EQ(ids(link_vertices(complex, Vertex{0})), (Ids{3, 4, 5, 6, 1, 2}));
}

// Without triangle 2 the star of the centre is open: it runs from triangle 3 around to 1, whichever
// corner the vertex stores.
TYPED_TEST(Ranges, OfAStarAndALinkBeginAtTheDomainBoundary) {
    auto complex = hexagon<TypeParam>();
    remove(complex, SimplexSet({}, {}, {Triangle{2}}));
    for (const std::uint32_t t : {1U, 3U, 5U}) {
        complex.vertices[0].corner = corner_of(t, 0);
        EXPECT_EQ(ids(star_triangles(complex, Vertex{0})), (Ids{3, 4, 5, 6, 1}));
        EXPECT_EQ(ids(link_vertices(complex, Vertex{0})), (Ids{3, 4, 5, 6, 1, 2}));
    }
    // A vertex with a single triangle.
    EXPECT_EQ(ids(star_triangles(complex, Vertex{3})), (Ids{3}));
    EXPECT_EQ(ids(link_vertices(complex, Vertex{3})), (Ids{4, 0}));
}

TYPED_TEST(Ranges, OfAVertexWithoutTrianglesAreEmpty) {
    Complex<TypeParam> complex;
    const Vertex v = insert_vertex(complex, Point<TypeParam>(1, 2));
    EXPECT_EQ(ids(vertices(complex)), (Ids{0}));
    EXPECT_TRUE(star_triangles(complex, v).empty());
    EXPECT_TRUE(link_vertices(complex, v).empty());
}

// Triangle 2 is removed before the loop reaches it; an id that the loop has passed is reused, and
// id 7 is added beyond its end. The records move meanwhile.
TYPED_TEST(Ranges, AllowChangesOfConnectivity) {
    auto complex = hexagon<TypeParam>();
    Ids met;
    for (const Triangle t : triangles(complex)) {
        met.push_back(t.id);
        if (t.id == 1) {
            remove(complex, SimplexSet({}, {}, {Triangle{2}}));
        } else if (t.id == 3 || t.id == 5) {
            complex.reserve(100 * t.id, 100 * t.id);
            ASSERT_EQ(edge_split(complex, complex.edges_of(t)[0]).verdict, Verdict::legal);
        }
    }
    EXPECT_EQ(met, (Ids{1, 3, 4, 5, 6}));
    EXPECT_EQ(ids(triangles(complex)), (Ids{1, 2, 3, 4, 5, 6, 7}));
}

} // namespace
} // namespace dsc::ranges_test
