// SPDX-License-Identifier: MIT
// Triangle collapse on hand-sized complexes: each verdict, each choice of the vertex that remains.
// A refused operation changes no byte; every result is validated.
#include "support/operations_testing.h"
#include "support/random/complex.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/complex/circulate.h"
#include "thesis/triangle_collapse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dsc::test::triangle_collapse_test {
namespace {

template <class Real>
class TriangleCollapse : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(TriangleCollapse, Reals);

// In the middle of grid(5): its vertices (2, 2), (3, 2) and (2, 3) or (3, 3) are 14, 15 and 20 or
// 21.
constexpr Triangle middle{25};

// A small triangle in a hexagon: vertices 0 to 2, triangle 1. Vertices 3 to 8 are around it.
// Triangles 2, 5 and 8 have one of its vertices, 0, 1 and 2; triangles 4, 7 and 10 have two.
template <class Real>
Complex<Real> in_hexagon() {
    std::vector<Point<Real>> points;
    const auto add = [&](double radius, double angle_deg) {
        const double angle = angle_deg * 3.14159265358979323846 / 180;
        points.emplace_back(static_cast<Real>(radius * std::cos(angle)),
                            static_cast<Real>(radius * std::sin(angle)));
    };
    for (int i = 0; i < 3; ++i) {
        add(1, 120 * i);
    }
    for (int k = 0; k < 6; ++k) {
        add(10, 60 * k);
    }
    std::vector<Indices> list{{0, 1, 2}};
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t here = 3 + 2 * i;
        const std::uint32_t before = i == 0 ? 8 : here - 1;
        list.push_back({i, before, here});
        list.push_back({i, here, here + 1});
        list.push_back({i, here + 1, (i + 1) % 3});
    }
    return build<Real>(points, list, std::vector<Phase>(list.size(), 0));
}

template <class Real>
auto collapse(Triangle t, const TriangleCollapseOptions<Real>& options = {}) {
    return [t, options](const auto& submesh) {
        return triangle_collapse(submesh, t, options).verdict;
    };
}

template <class Real>
double whole_area(const Complex<Real>& K) {
    double sum = 0;
    for (const Triangle t : triangles(K)) {
        const auto [a, b, c] = K.vertices_of(t);
        sum += static_cast<double>(area<Real>(K.position(a), K.position(b), K.position(c)));
    }
    return sum;
}

// Triangle 1 is (0, 2, 1). Vertex 0 has degree three: around it is the triangle (1, 2, 3).
template <class Real>
Complex<Real> with_degree_three() {
    const std::vector<Point<Real>> points{{-1, 0}, {0, 1}, {0, -1}, {-4, 0},
                                          {4, 0},  {0, 6}, {0, -6}};
    return build<Real>(
        points,
        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}, {1, 4, 5}, {1, 5, 3}, {2, 3, 6}, {2, 6, 4}},
        std::vector<Phase>(8, 0));
}

TYPED_TEST(TriangleCollapse, ThreeVerticesBecomeOneAtTheCentroid) {
    auto K = grid<TypeParam>(5);
    const auto [a, b, c] = K.vertices_of(middle);
    const Point<TypeParam> centroid =
        (K.position(a) + K.position(b) + K.position(c)) / TypeParam(3);
    const std::uint32_t vertices_before = K.vertex_count();
    const std::uint32_t triangles_before = K.triangle_count();
    const auto result = triangle_collapse(K, middle);
    ASSERT_EQ(result.verdict, Verdict::legal);
    expect_valid(K);
    EXPECT_EQ(result.vertex, std::min({a, b, c}));
    EXPECT_EQ(K.position(result.vertex), centroid);
    EXPECT_EQ(K.vertex_count(), vertices_before - 2);
    EXPECT_EQ(K.triangle_count(), triangles_before - 4);
    EXPECT_NEAR(whole_area(K), 25, 1e-5);
    EXPECT_FALSE(K.is_alive(middle));
    EXPECT_EQ(K.journal.counts.collapses, 2U);
}

TYPED_TEST(TriangleCollapse, IsRefused) {
    auto K = grid<TypeParam>(5);
    const auto [a, b, c] = K.vertices_of(middle);
    expect_refused(K, Verdict::not_a_simplex, collapse<TypeParam>(Triangle{}));
    expect_refused(K, Verdict::not_a_simplex, collapse<TypeParam>(Triangle{border_triangle}));
    expect_refused(K, Verdict::on_boundary, collapse<TypeParam>(Triangle{1}));
    // Beyond the vertices of the star.
    expect_refused(K, Verdict::inverts, collapse<TypeParam>(middle, {.place = {{0, 0}}}));
    std::vector<std::uint32_t> labels(K.vertex_bound(), 1);
    labels[a.id] = 0;
    expect_refused(K, Verdict::on_submesh_boundary, collapse<TypeParam>(middle), labels);
    labels[a.id] = 1;
    labels[7] = 0; // (1, 1): the star of (2, 2) is not owned as a whole, wherever its diagonals run
    labels[8] = 0;
    labels[13] = 0;
    expect_refused(K, Verdict::on_submesh_boundary, collapse<TypeParam>(middle), labels);
    K.set_locked(a, true);
    expect_refused(K, Verdict::locked, collapse<TypeParam>(middle, {.place = K.position(b)}));
    K.set_locked(c, true);
    expect_refused(K, Verdict::locked, collapse<TypeParam>(middle));
}

TYPED_TEST(TriangleCollapse, ThePlaceBelongsToTheSubmesh) {
    auto K = grid<TypeParam>(5);
    Submesh submesh = Submesh(K);
    submesh.region.kind = Region::Kind::box;
    submesh.region.low = 0.5; // owns all stars of the middle
    submesh.region.high = 4.5;
    const Point<TypeParam> beyond(TypeParam(0.25), 2);
    EXPECT_EQ(triangle_collapse(submesh, middle, {.place = beyond}).verdict,
              Verdict::on_submesh_boundary);
    EXPECT_EQ(triangle_collapse(submesh, middle).verdict, Verdict::legal);
    expect_valid(K);
}

TYPED_TEST(TriangleCollapse, APlaceThatIsNotFiniteIsBadInput) {
    auto K = grid<TypeParam>(5);
    const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
    EXPECT_THROW((void)triangle_collapse(K, middle, {.place = {{nan, 1}}}), InputError);
}

// The edges that the remaining vertex had keep their data, even one that would be lost from sight
// if the vertex of degree three went last.
TYPED_TEST(TriangleCollapse, EdgesOfTheVertexThatRemainsKeepTheirData) {
    for (std::uint32_t heir = 0; heir < 3; ++heir) {
        auto K = with_degree_three<TypeParam>();
        auto& data = K.attributes.template add<Edge, double>("name");
        const auto name = [](Vertex a, Vertex b) { return a.id + 10.0 * b.id; };
        for (std::uint32_t a = 0; a < 7; ++a) {
            for (std::uint32_t b = a + 1; b < 7; ++b) {
                if (const Edge e = K.find_edge(Vertex{a}, Vertex{b}); e.is_valid()) {
                    data.set(K, e, name(Vertex{a}, Vertex{b}));
                }
            }
        }
        std::vector<Vertex> known;
        for (std::uint32_t w = 3; w < 7; ++w) {
            if (K.find_edge(Vertex{heir}, Vertex{w}).is_valid()) {
                known.push_back(Vertex{w});
            }
        }
        K.set_locked(Vertex{heir}, true);
        ASSERT_EQ(triangle_collapse(K, Triangle{1}).verdict, Verdict::legal);
        for (const Vertex w : known) {
            const Edge e = K.find_edge(Vertex{heir}, w);
            ASSERT_TRUE(e.is_valid());
            EXPECT_EQ(data[e], name(Vertex{heir}, w));
        }
    }
}

// Two sheets with a gap of one row of squares between them: 2 < y < 3 is exterior.
template <class Real>
Complex<Real> two_sheets() {
    auto K = grid<Real>(6);
    for (const Triangle t : triangles(K)) {
        const auto [a, b, c] = K.vertices_of(t);
        const Real y = (K.position(a) + K.position(b) + K.position(c)).y() / 3;
        K.set_phase(t, y > 2 && y < 3 ? 0 : y < 2 ? 1 : 2);
    }
    return K;
}

TYPED_TEST(TriangleCollapse, AnInterfaceVertexOrACornerIsKept) {
    // One vertex of the triangle is on the interface: it remains, whether or not it may move.
    for (const InterfaceRule rule : {InterfaceRule::keep, InterfaceRule::change}) {
        auto K = in_hexagon<TypeParam>();
        K.set_phase(Triangle{5}, 1);
        const Point<TypeParam> place = K.position(Vertex{1});
        const auto result = triangle_collapse(K, Triangle{1}, {.interface = rule});
        EXPECT_EQ(result.vertex, Vertex{1});
        EXPECT_EQ(K.position(Vertex{1}), place);
        expect_valid(K);
    }
    // All are, and one of them is a corner.
    const auto K = two_sheets<TypeParam>();
    const Triangle t{2 * (2 * 6 + 2) + 1};
    const auto [a, b, c] = K.vertices_of(t);
    const Point<TypeParam> centroid =
        (K.position(a) + K.position(b) + K.position(c)) / TypeParam(3);
    for (std::uint32_t i = 0; i < 3; ++i) {
        auto copy = K;
        const Vertex corner = copy.vertices_of(t)[i];
        copy.vertices[corner.id].flags |= vertex_corner;
        const auto result =
            triangle_collapse(copy, t, {.place = centroid, .interface = InterfaceRule::change});
        EXPECT_EQ(result.verdict, Verdict::legal);
        EXPECT_EQ(result.vertex, corner);
        expect_valid(copy);
    }
}

} // namespace
} // namespace dsc::test::triangle_collapse_test
