// SPDX-License-Identifier: MIT
// Simplex algebra (thesis, section 3.1) against its own definitions over vertex sets, the thesis's
// figures 3.3 to 3.9 on a fan of six, and the operations of sets.
#include "thesis/sets/algebra.h"

#include "support/literal_sets.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/complex/ranges.h"
#include "dsc/queries/phases.h"
#include "dsc/queries/validate.h"
#include "thesis/sets/insertion_removal.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dsc::algebra_test {
namespace {

using test::everything;
using test::Family;
using test::family;
using test::grid;
using test::hexagon;
using test::some_of;
using test::Vert;
using test::vert;

template <class Real>
class Algebra : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Algebra, Reals);

// --- the definitions, literally: a simplex is its set of vertices --------------------------------

bool subset(const Vert& a, const Vert& b) {
    return std::includes(b.begin(), b.end(), a.begin(), a.end());
}

Family star_of(const Family& all, const Family& members) {
    Family result;
    for (const Vert& s : members) {
        for (const Vert& other : all) {
            if (subset(s, other)) {
                result.insert(other);
            }
        }
    }
    return result;
}
Family closure_of(const Family& all, const Family& members) {
    Family result;
    for (const Vert& s : members) {
        for (const Vert& other : all) {
            if (subset(other, s)) {
                result.insert(other);
            }
        }
    }
    return result;
}
Family minus(const Family& a, const Family& b) {
    Family result;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(),
                        std::inserter(result, result.end()));
    return result;
}
Family link_of(const Family& all, const Vert& s) {
    return minus(closure_of(all, star_of(all, {s})), star_of(all, closure_of(all, {s})));
}

template <class Real, class Simplex>
void expect_definitions(const Complex<Real>& complex, const Family& all, Simplex simplex) {
    const Vert s = vert(complex, simplex);
    SCOPED_TRACE(testing::PrintToString(s));
    Family faces = closure_of(all, {s});
    EXPECT_EQ(family(complex, closure(complex, simplex)), faces);
    faces.erase(s);
    EXPECT_EQ(family(complex, full_boundary(complex, simplex)), faces);
    std::erase_if(faces, [&](const Vert& f) { return f.size() + 1 != s.size(); });
    EXPECT_EQ(family(complex, boundary(complex, simplex)), faces);
    EXPECT_EQ(family(complex, star(complex, simplex)), star_of(all, {s}));
    EXPECT_EQ(family(complex, link(complex, simplex)), link_of(all, s));
    // the link composed of the library's star and closure must be the same
    EXPECT_EQ(link(complex, simplex),
              closure(complex, star(complex, simplex)) - star(complex, closure(complex, simplex)));
    // star and closure are idempotent
    const SimplexSet around = star(complex, simplex);
    EXPECT_EQ(star(complex, around), around);
    const SimplexSet closed = closure(complex, simplex);
    EXPECT_EQ(closure(complex, closed), closed);
}

template <class Real>
void expect_definitions(const Complex<Real>& complex) {
    const Family all = everything(complex);
    const SimplexSet k = all_simplices(complex);
    ASSERT_EQ(family(complex, k), all);
    ASSERT_EQ(k.size(), all.size()) << "an edge has two handles";
    for (const Vertex v : k.vertices()) {
        expect_definitions(complex, all, v);
    }
    for (const Edge e : k.edges()) {
        expect_definitions(complex, all, e);
    }
    for (const Triangle t : k.triangles()) {
        expect_definitions(complex, all, t);
    }
}

// --- relations and operations --------------------------------------------------------------------

TYPED_TEST(Algebra, RelationsAreTheirDefinitions) {
    expect_definitions(hexagon<TypeParam>());
    expect_definitions(grid<TypeParam>(4, 0.15, 7));
}

TYPED_TEST(Algebra, RelationsAreTheirDefinitionsWhereIdsAreFree) {
    auto complex = grid<TypeParam>(4, 0.15, 8);
    SimplexSet hole;
    hole.insert(Vertex{12});  // in the middle: the domain gets a hole
    hole.insert(Triangle{1}); // at a corner of the domain
    remove(complex, hole);
    ASSERT_EQ(validate(complex).problem, "");
    // The vertex at the corner may be left without triangles; its star is then only itself.
    SimplexSet unused;
    for (const Vertex v : vertices(complex)) {
        if (complex.vertices[v.id].corner == no_id) {
            unused.insert(v);
        }
    }
    for (const Vertex v : unused.vertices()) {
        EXPECT_EQ(star(complex, v).size(), 1U);
        EXPECT_TRUE(link(complex, v).empty());
    }
    remove(complex, unused);
    expect_definitions(complex);
    EXPECT_TRUE(star(complex, Vertex{12}).empty());
    EXPECT_TRUE(closure(complex, Triangle{1}).empty());
    EXPECT_TRUE(closure(complex, Vertex{no_id}).empty());
    EXPECT_TRUE(star(complex, Edge{no_id}).empty());
    EXPECT_TRUE(link(complex, Triangle{0}).empty()) << "the border is no simplex";
    EXPECT_TRUE(boundary(complex, Triangle{1000}).empty());
}

TYPED_TEST(Algebra, OperationsOnSetsAreUnions) {
    const auto complex = grid<TypeParam>(5, 0.15, 3);
    const SimplexSet all = all_simplices(complex);
    std::mt19937 random(5);
    for (int i = 0; i < 20; ++i) {
        const SimplexSet set = some_of(all, random);
        SimplexSet boundaries;
        SimplexSet stars;
        SimplexSet closures;
        SimplexSet links;
        const auto add = [&](const auto& simplices) {
            for (const auto s : simplices) {
                boundaries.insert(boundary(complex, s));
                stars.insert(star(complex, s));
                closures.insert(closure(complex, s));
                links.insert(link(complex, s));
            }
        };
        add(set.vertices());
        add(set.edges());
        add(set.triangles());
        EXPECT_EQ(boundary(complex, set), boundaries);
        EXPECT_EQ(star(complex, set), stars);
        EXPECT_EQ(closure(complex, set), closures);
        EXPECT_EQ(link(complex, set), links);
        EXPECT_TRUE(stars.contains(set) && closures.contains(set));
    }
}

TYPED_TEST(Algebra, Figures38And39SkeletonAndFilter) {
    const auto k = hexagon<TypeParam>();
    const SimplexSet set = star(k, Vertex{0}) | closure(k, Triangle{1});
    EXPECT_EQ(skeleton(set, 0), SimplexSet(set.vertices(), {}, {}));
    EXPECT_EQ(skeleton(set, 1), SimplexSet(set.vertices(), set.edges(), {}));
    EXPECT_EQ(skeleton(set, 2), set);
    EXPECT_EQ(filter(set, 0), SimplexSet(set.vertices(), {}, {}));
    EXPECT_EQ(filter(set, 1), SimplexSet({}, set.edges(), {}));
    EXPECT_EQ(filter(set, 2), SimplexSet({}, {}, set.triangles()));
    EXPECT_EQ(filter(set, 0) | filter(set, 1) | filter(set, 2), set);
    EXPECT_THROW((void)skeleton(set, 3), InputError);
    EXPECT_THROW((void)filter(set, -1), InputError);
}

// --- sets ----------------------------------------------------------------------------------------

// Compares the operations with those of std::set on simplices that are sets of vertices.
TEST(SimplexSets, HaveTheOperationsOfSets) {
    std::mt19937 random(11);
    const auto complex = grid<double>(4);
    const SimplexSet all = all_simplices(complex);
    for (int i = 0; i < 200; ++i) {
        const SimplexSet a = some_of(all, random);
        const SimplexSet b = some_of(all, random);
        const Family of_a = family(complex, a);
        const Family of_b = family(complex, b);
        Family of_both = of_a;
        of_both.insert(of_b.begin(), of_b.end());
        EXPECT_EQ(family(complex, a | b), of_both);
        EXPECT_EQ((a | b).size(), of_both.size());
        EXPECT_EQ(family(complex, a - b), minus(of_a, of_b));
        EXPECT_EQ(family(complex, a & b), minus(of_a, minus(of_a, of_b)));
        EXPECT_TRUE((a | b).contains(a) && a.contains(a & b) && a.contains(SimplexSet{}));
        EXPECT_EQ(a.contains(b), minus(of_b, of_a).empty());
        EXPECT_EQ(a == b, of_a == of_b);
        SimplexSet one_by_one = a;
        for (const Vertex s : b.vertices()) {
            EXPECT_EQ(one_by_one.insert(s), !a.contains(s));
        }
        for (const Edge s : b.edges()) {
            EXPECT_EQ(one_by_one.insert(s), !a.contains(s));
        }
        for (const Triangle s : b.triangles()) {
            EXPECT_EQ(one_by_one.insert(s), !a.contains(s));
        }
        EXPECT_EQ(one_by_one, a | b);
    }
}

} // namespace
} // namespace dsc::algebra_test
