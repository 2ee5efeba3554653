// SPDX-License-Identifier: MIT
// The validator detects every kind of fault and names the bad element. Each fault is written into
// the records of a sound complex, or built into a mesh.
#include "dsc/queries/validate.h"

#include "support/small_meshes.h"
#include "support/validate_testing.h"

#include "dsc/base/error.h"
#include "dsc/queries/phases.h"
#include "thesis/sets/algebra.h"
#include "thesis/sets/insertion_removal.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace dsc::validate_test {
namespace {

using test::expect_problem;
using test::grid;
using test::hexagon;

template <class Real>
class Validate : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Validate, Reals);

// A grid with a free vertex (id 60), free triangles, and an unused vertex; vertex 24 is in the
// middle.
template <class Real>
Complex<Real> sound() {
    auto complex = grid<Real>(6, 0.15, 3, 2);
    complex.attributes.template add<Vertex, double>("p");
    complex.attributes.template add<Edge, int>("e");
    complex.attributes.template add<Triangle, float>("t");
    insert_vertex(complex, Point<Real>(9, 9));
    remove(complex, SimplexSet({insert_vertex(complex, Point<Real>(8, 8))}, {}, {Triangle{60}}));
    return complex;
}

// A corner that no vertex refers to, of a triangle away from the domain boundary.
template <class Real>
Corner quiet_corner(const Complex<Real>& complex) {
    for (std::uint32_t t = 20; t < complex.triangle_bound(); ++t) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner c = corner_of(t, i);
            if (!is_boundary(complex, Triangle{t}) &&
                complex.vertices[complex.vertex(c)].corner != c) {
                return c;
            }
        }
    }
    return no_id;
}

TYPED_TEST(Validate, SoundComplexesPass) {
    const ValidationReport disc = validate(hexagon<TypeParam>());
    EXPECT_EQ(disc.problem, "");
    EXPECT_EQ(disc.vertices, 7U);
    EXPECT_EQ(disc.edges, 12U);
    EXPECT_EQ(disc.triangles, 6U);
    EXPECT_EQ(disc.euler_characteristic, 1);
    EXPECT_EQ(disc.components, 1U);
    EXPECT_EQ(disc.boundary_loops, 1U);
    EXPECT_EQ(disc.unused_vertices, 0U);
    EXPECT_TRUE(validate(Complex<TypeParam>()).ok());
    const auto complex = sound<TypeParam>();
    EXPECT_EQ(validate(complex).problem, "");
    EXPECT_EQ(validate(complex).unused_vertices, 1U);
    EXPECT_NO_THROW(validate_or_throw(complex));
}

TYPED_TEST(Validate, CountsHolesAndComponents) {
    auto complex = grid<TypeParam>(6, 0.15, 3);
    remove(complex, SimplexSet({Vertex{24}}, {}, {})); // a hole in the middle
    const ValidationReport ring = validate(complex);
    EXPECT_EQ(ring.problem, "");
    EXPECT_EQ(ring.euler_characteristic, 0);
    EXPECT_EQ(ring.components, 1U);
    EXPECT_EQ(ring.boundary_loops, 2U);
    // A small triangle inside the hole, and one outside the domain: components of their own.
    for (const auto x : {TypeParam(3), TypeParam(20)}) {
        const auto a = insert_vertex(complex, Point<TypeParam>(x, 3));
        const auto b = insert_vertex(complex, Point<TypeParam>(x + TypeParam(0.25), 3));
        const auto c = insert_vertex(complex, Point<TypeParam>(x, TypeParam(3.25)));
        insert_triangle(complex, a, b, c, 0);
    }
    const ValidationReport three = validate(complex);
    EXPECT_EQ(three.problem, "");
    EXPECT_EQ(three.euler_characteristic, 2);
    EXPECT_EQ(three.components, 3U);
    EXPECT_EQ(three.boundary_loops, 4U);
    std::size_t edges = filter(all_simplices(complex), 1).size();
    EXPECT_EQ(three.edges, edges);
}

TYPED_TEST(Validate, SeesFaultsInRecords) {
    using K = Complex<TypeParam>;
    const K good = sound<TypeParam>();
    const Corner c = quiet_corner(good);
    ASSERT_NE(c, no_id);
    const std::uint32_t t = triangle_of(c);
    const std::uint32_t i = index_of(c);
    const std::string triangle = "triangle " + std::to_string(t);
    const std::uint32_t dead_vertex = good.ids.vertices.at(0);
    const std::uint32_t dead_triangle = good.ids.triangles.at(0);
    const TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
    struct Fault {
        std::string words;
        std::function<void(K&)> seed;
    };
    const std::vector<Fault> faults{
        {"the border, is missing", [](K& k) { k.triangles.clear(); }},
        {"the border: its phase", [](K& k) { k.triangles[0].phase = 0; }},
        {"the border: its record", [](K& k) { k.triangles[0].n[1] = 8; }},
        {"the border: its record", [](K& k) { k.triangles[0].v[2] = 3; }},
        {"attribute 'p'",
         [](K& k) { k.attributes.template get<Vertex, double>("p").data().pop_back(); }},
        {"attribute 'e'",
         [](K& k) { k.attributes.template get<Edge, int>("e").data().push_back(1); }},
        {"attribute 't'",
         [](K& k) { k.attributes.template get<Triangle, float>("t").data().clear(); }},
        {"vertex 24 at (nan", [&](K& k) { k.vertices[24].x = nan; }},
        {"not finite",
         [&](K& k) { k.vertices[24].y = std::numeric_limits<TypeParam>::infinity(); }},
        {"vertex 24", [&](K& k) { k.vertices[24].corner = corner_of(dead_triangle, 0); }},
        {"vertex 24", [](K& k) { k.vertices[24].corner |= 3U; }},
        {"vertex 24", [](K& k) { k.vertices[24].corner = 0x7fffffff; }},
        {"vertex 24", [](K& k) { k.vertices[24].corner = 1; }},
        {"vertex 24", [](K& k) { k.vertices[24].corner = next(k.vertices[24].corner); }},
        {"vertex 24 at", [](K& k) { k.vertices[24].corner = no_id; }},
        {"vertex 99 is not alive", [&](K& k) { k.triangles[t].v[i] = 99; }},
        {"vertex 4294967295 is not alive", [&](K& k) { k.triangles[t].v[i == 0 ? 1 : i] = no_id; }},
        {"is not alive", [&](K& k) { k.triangles[t].v[i] = dead_vertex; }},
        {"named twice", [&](K& k) { k.triangles[t].v[i] = k.vertex(next(c)); }},
        {triangle + " (", [&](K& k) { k.triangles[t].phase = border_phase; }},
        {"is not alive", [&](K& k) { k.triangles[t].n[i] = corner_of(dead_triangle, 1); }},
        {"is not alive", [&](K& k) { k.triangles[t].n[i] |= 3U; }},
        {"is not alive", [&](K& k) { k.triangles[t].n[i] = no_id; }},
        {"its own neighbour", [&](K& k) { k.triangles[t].n[i] = next(c); }},
        {"link back", [&](K& k) { k.triangles[t].n[i] = next(k.triangles[t].n[i]); }},
        {"link back", [&](K& k) { k.triangles[t].n[i] = border_corner; }},
        {"the same two vertices", [&](K& k) { k.triangles[t].v[i] = 48; }},
        {"the same two vertices",
         [&](K& k) {
             // The links to neighbours are symmetric, but join unrelated edges.
             const Corner far = corner_of(1, 0);
             const Corner a = k.twin(c);
             const Corner b = k.twin(far);
             k.triangles[t].n[i] = far;
             k.triangles[1].n[0] = c;
             for (const Corner left : {a, b}) {
                 if (!is_border(left)) {
                     k.triangles[triangle_of(left)].n[index_of(left)] = 0;
                 }
             }
         }},
        {"is inverted",
         [](K& k) {
             k.set_position(Vertex{24}, {100, 100});
         }},
        {"free vertex 999", [](K& k) { k.ids.vertices.push_back(999); }},
        {"free vertex 24: it is alive", [](K& k) { k.ids.vertices.push_back(24); }},
        {"is free twice", [](K& k) { k.ids.vertices.push_back(k.ids.vertices[0]); }},
        {"dead, but not free", [](K& k) { k.ids.vertices.clear(); }},
        {"free triangle 999", [](K& k) { k.ids.triangles.push_back(999); }},
        {"free triangle 0", [](K& k) { k.ids.triangles.push_back(0); }},
        {"free triangle 5: it is alive", [](K& k) { k.ids.triangles.push_back(5); }},
        {"is free twice", [](K& k) { k.ids.triangles.push_back(k.ids.triangles[0]); }},
        {"triangle " + std::to_string(dead_triangle) + ": it is dead, but not free",
         [](K& k) { k.ids.triangles.clear(); }},
        {"free triangle 5: it is alive", [](K& k) { k.ids.lend(1).triangles.push_back(5); }},
        {"is free twice", [](K& k) { k.ids.lend(0).vertices.push_back(k.ids.vertices[0]); }},
        {"vertex 24 is not alive", [](K& k) { k.vertices[24].flags |= vertex_dead; }},
        {"is not alive", [&](K& k) { k.triangles[t].v[0] = no_id; }},
    };
    for (const Fault& fault : faults) {
        K bad = good;
        fault.seed(bad);
        expect_problem(bad, fault.words);
    }
    EXPECT_EQ(validate(good).problem, "");
}

TYPED_TEST(Validate, SeesADegenerateTriangle) {
    auto complex = grid<TypeParam>(1);
    const Corner c = corner_of(1, 0);
    const Corner apex =
        is_border(complex.twin(c)) ? (is_border(complex.twin(c + 1)) ? c + 2 : c + 1) : c;
    complex.set_position(Vertex{complex.vertex(apex)}, {TypeParam(0.5), TypeParam(0.5)});
    expect_problem(complex, "triangle 1 (");
    expect_problem(complex, "it is degenerate");
}

TYPED_TEST(Validate, LentIdsAreNotMissing) {
    auto complex = sound<TypeParam>();
    const std::uint32_t triangles = complex.triangle_count();
    move_ids(complex.ids, complex.ids.lend(2), 0, 0);
    EXPECT_TRUE(complex.ids.triangles.empty());
    EXPECT_EQ(complex.triangle_count(), triangles);
    EXPECT_EQ(validate(complex).problem, "");
}

TYPED_TEST(Validate, SeesVerticesThatAreNotManifold) {
    auto complex = hexagon<TypeParam>();
    remove(complex, SimplexSet({}, {}, {Triangle{1}, Triangle{4}}));
    expect_problem(complex, "vertex 0 at (0, 0): it is not manifold: 4 triangles name it, rotating "
                            "about it meets 2");
}

} // namespace
} // namespace dsc::validate_test
