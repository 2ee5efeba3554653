// SPDX-License-Identifier: MIT
// The mesh functions (thesis, sections 4.1 and 8.6): insertion in any order, removal, and the
// submesh boundary.
#include "thesis/sets/insertion_removal.h"
#include "thesis/sets/mesh_functions.h"

#include "support/literal_sets.h"
#include "support/refusal.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/queries/validate.h"
#include "thesis/sets/algebra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace dsc::mesh_functions_test {
namespace {

using test::everything;
using test::Family;
using test::family;
using test::grid;
using test::hexagon;
using test::some_of;

template <class Real>
class MeshFunctions : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(MeshFunctions, Reals);

TYPED_TEST(MeshFunctions, RemoveAndReinsertInAnyOrderAndOrientation) {
    const auto source = grid<TypeParam>(6, 0.15, 5, 2);
    const Family all = everything(source);
    std::mt19937 random(9);
    for (int i = 0; i < 50; ++i) {
        auto complex = source;
        std::vector<std::pair<std::array<Vertex, 3>, Phase>> removed;
        const auto doomed = some_of(filter(all_simplices(complex), 2), random).triangles();
        for (const Triangle t : doomed) {
            removed.push_back({complex.vertices_of(t), complex.phase(t)});
        }
        if (i % 2 == 0) {
            EXPECT_EQ(remove(complex, SimplexSet({}, {}, doomed)), doomed.size());
        } else {
            for (const Triangle t : doomed) {
                EXPECT_EQ(remove(complex, SimplexSet({}, {}, {t})), 1U);
            }
        }
        EXPECT_EQ(complex.triangle_count(), 72 - doomed.size());
        EXPECT_EQ(complex.vertex_count(), 49U) << "a triangle leaves its vertices";
        std::shuffle(removed.begin(), removed.end(), random);
        for (auto& [v, phase] : removed) {
            std::shuffle(v.begin(), v.end(), random);
            insert_triangle(complex, v[0], v[1], v[2], phase);
        }
        ASSERT_EQ(validate(complex).problem, "");
        EXPECT_EQ(everything(complex), all);
        EXPECT_EQ(family(complex, interface_of(complex)), family(source, interface_of(source)));
        EXPECT_EQ(complex.triangle_bound(), source.triangle_bound()) << "free ids are used again";
    }
}

TYPED_TEST(MeshFunctions, RemovalTakesSuperfacesAlong) {
    auto complex = hexagon<TypeParam>();
    const Edge incident_edge = complex.find_edge(Vertex{0}, Vertex{2});
    EXPECT_EQ(remove(complex, SimplexSet({}, {incident_edge}, {})), 2U);
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_FALSE(is_valid_simplex(complex, complex.find_edge(Vertex{0}, Vertex{2})));
    EXPECT_TRUE(is_valid_simplex(complex, Vertex{2})) << "lives on without triangles";
    EXPECT_EQ(complex.vertices[2].corner, no_id);
    EXPECT_TRUE(is_valid_simplex(complex, complex.find_edge(Vertex{0}, Vertex{1})));
    EXPECT_EQ(remove(complex, SimplexSet({Vertex{0}}, {}, {})), 4U);
    EXPECT_EQ(complex.triangle_count(), 0U);
    EXPECT_EQ(complex.vertex_count(), 6U);
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_EQ(validate(complex).unused_vertices, 6U);
    EXPECT_EQ(remove(complex, SimplexSet({Vertex{0}}, {incident_edge}, {Triangle{1}})), 0U);
}

TYPED_TEST(MeshFunctions, RemovalOfAVertexWithTwoFansTakesBoth) {
    auto complex = hexagon<TypeParam>();
    remove(complex, SimplexSet({}, {}, {Triangle{1}, Triangle{4}}));
    ASSERT_NE(validate(complex).problem, "") << "vertex 0 has two fans now";
    EXPECT_EQ(remove(complex, SimplexSet({Vertex{0}}, {}, {})), 4U);
    EXPECT_EQ(validate(complex).problem, "");
}

TYPED_TEST(MeshFunctions, InsertionRefusesWhatIsNoComplex) {
    auto complex = hexagon<TypeParam>();
    const auto before = everything(complex);
    const Vertex far = insert_vertex(complex, Point<TypeParam>(5, 0));
    const Vertex line = insert_vertex(complex, Point<TypeParam>(2, 0));
    const Vertex inside = insert_vertex(complex, Point<TypeParam>(TypeParam(0.5), TypeParam(0.1)));
    const auto refused = [&](Vertex a, Vertex b, Vertex c, Phase phase, const char* word) {
        const std::string sentence =
            test::refusal([&] { insert_triangle(complex, a, b, c, phase); });
        EXPECT_NE(sentence.find(word), std::string::npos) << word << ": " << sentence;
    };
    refused(Vertex{0}, far, line, 0, "degenerate");
    refused(Vertex{1}, Vertex{1}, far, 0, "named twice");
    refused(Vertex{1}, Vertex{2}, Vertex{99}, 0, "is not alive");
    refused(Vertex{1}, Vertex{2}, Vertex{no_id}, 0, "is not alive");
    refused(Vertex{1}, Vertex{2}, far, border_phase, "reserved");
    refused(Vertex{0}, Vertex{1}, far, 0, "degenerate");
    refused(Vertex{0}, Vertex{2}, far, 0, "two triangles already");
    refused(Vertex{1}, Vertex{2}, inside, 0, "overlaps");
    EXPECT_THROW(insert_vertex(complex, Point<TypeParam>(0, std::nan(""))), InputError);
    EXPECT_EQ(everything(complex), before);
    EXPECT_EQ(validate(complex).problem, "");
    insert_triangle(complex, Vertex{2}, Vertex{1}, far, 3);
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_EQ(phases(complex), (std::vector<Phase>{0, 3}));
    const Vertex last = insert_vertex(complex, Point<TypeParam>(0, -5));
    complex.ids.may_grow = false;
    refused(Vertex{6}, Vertex{5}, last, 0, "no free id");
    EXPECT_THROW(insert_vertex(complex, Point<TypeParam>(0, 9)), InputError);
}

TYPED_TEST(MeshFunctions, AttributesFollow) {
    auto complex = hexagon<TypeParam>();
    auto& at_vertex = complex.attributes.template add<Vertex, double>("p", 7.0);
    auto& at_edge = complex.attributes.template add<Edge, int>("weight", 5);
    auto& at_triangle = complex.attributes.template add<Triangle, float>("q", 3.0F);
    std::ranges::fill(at_vertex.data(), 1);
    std::ranges::fill(at_edge.data(), 1);
    std::ranges::fill(at_triangle.data(), 1);
    remove(complex, SimplexSet({}, {}, {Triangle{2}}));
    for (std::uint32_t i = 0; i < 4; ++i) {
        at_edge.data()[corner_of(2, i)] = 99; // the data of free ids do not matter
    }
    const Triangle t = insert_triangle(complex, Vertex{0}, Vertex{2}, Vertex{3}, 0);
    EXPECT_EQ(at_triangle[t], 3.0F);
    EXPECT_EQ(at_edge[complex.find_edge(Vertex{0}, Vertex{2})], 1) << "it existed";
    EXPECT_EQ(at_edge[complex.find_edge(Vertex{2}, Vertex{3})], 5) << "it is new";
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Corner c = corner_of(t.id, i);
        if (!is_border(complex.twin(c))) {
            EXPECT_EQ(at_edge.data()[c], at_edge.data()[complex.twin(c)]);
        }
    }
    remove(complex, SimplexSet({Vertex{3}}, {}, {}));
    const Vertex v = insert_vertex(complex, Point<TypeParam>(9, 9));
    EXPECT_EQ(v, Vertex{3});
    EXPECT_EQ(at_vertex[v], 7.0);
    EXPECT_EQ(validate(complex).problem, "");
}

} // namespace
} // namespace dsc::mesh_functions_test
