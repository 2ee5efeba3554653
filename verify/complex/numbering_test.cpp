// SPDX-License-Identifier: MIT
// Numbering along the Hilbert curve, and the hash that does not depend on the numbering.
#include "dsc/complex/complex.h"

#include "support/literal_sets.h"
#include "support/random/complex.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/complex/numbering.h"
#include "dsc/complex/ranges.h"
#include "dsc/queries/validate.h"
#include "replay/mesh_hash.h"
#include "thesis/sets/algebra.h"
#include "thesis/sets/insertion_removal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <set>

namespace dsc::numbering_test {
namespace {

using test::build;
using test::grid;
using test::hexagon;
using test::Indices;

template <class Real>
class Numbering : public testing::Test {};
template <class Real>
class Hash : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Numbering, Reals);
TYPED_TEST_SUITE(Hash, Reals);

// The same mesh with its points, triangles and first corners in random order.
template <class Real>
Complex<Real> shuffled(const Complex<Real>& source, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint32_t> order(source.vertex_bound());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<Point<Real>> points(order.size());
    for (std::uint32_t v = 0; v < order.size(); ++v) {
        points[order[v]] = source.position(Vertex{v});
    }
    std::vector<std::pair<Indices, Phase>> list;
    for (std::uint32_t t = 1; t < source.triangle_bound(); ++t) {
        Indices v = source.triangles[t].v;
        std::rotate(v.begin(), v.begin() + random() % 3, v.end());
        list.push_back({{order[v[0]], order[v[1]], order[v[2]]}, source.triangles[t].phase});
    }
    std::shuffle(list.begin(), list.end(), random);
    std::vector<Indices> triangles;
    std::vector<Phase> phases;
    for (const auto& [v, phase] : list) {
        triangles.push_back(v);
        phases.push_back(phase);
    }
    return build<Real>(points, triangles, phases);
}

// With holes, free ids and unused vertices.
template <class Real>
Complex<Real> used(unsigned seed) {
    return test::random_complex<Real>(seed, {.points = 150, .scramble = 300, .locked = 0});
}

TEST(Hilbert, IsOneCurveAtFullOrder) {
    // At least one of the four neighbours of a cell far from the origin is the next cell on the
    // curve.
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const auto x = static_cast<std::uint32_t>(random() | 1U);
        const auto y = static_cast<std::uint32_t>(random() & ~1UL);
        const std::uint64_t here = hilbert_index(x, y);
        int steps = 0;
        for (const auto& [nx, ny] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
            const std::uint64_t there = hilbert_index(nx, ny);
            steps += there == here + 1 || there + 1 == here ? 1 : 0;
        }
        EXPECT_EQ(steps, 2);
    }
    const std::uint32_t top = 0xffffffffU;
    EXPECT_EQ(hilbert_index(0, 0), 0U);
    std::uint64_t largest = std::max(hilbert_index(top, 0), hilbert_index(0, top));
    EXPECT_EQ(largest, 0xffffffffffffffffU);
}

TYPED_TEST(Numbering, KeepsTheMeshAndCompactsIds) {
    std::size_t free_ids = 0;
    for (unsigned seed = 1; seed < 6; ++seed) {
        auto complex = used<TypeParam>(seed);
        free_ids += complex.ids.vertices.size();
        const auto before = complex;
        const Renumbering moved = renumber(complex);
        ASSERT_EQ(validate(complex).problem, "");
        EXPECT_EQ(mesh_hash(complex), mesh_hash(before));
        EXPECT_EQ(complex.vertex_bound(), before.vertex_count());
        EXPECT_EQ(complex.triangle_bound(), before.triangle_count() + 1);
        EXPECT_EQ(complex.vertex_count(), before.vertex_count());
        EXPECT_EQ(complex.triangle_count(), before.triangle_count());
        ASSERT_EQ(moved.vertices.size(), before.vertex_bound());
        ASSERT_EQ(moved.triangles.size(), before.triangle_bound());
        EXPECT_EQ(moved.triangles[0], 0U);
        for (std::uint32_t v = 0; v < before.vertex_bound(); ++v) {
            if (!before.is_alive(Vertex{v})) {
                EXPECT_EQ(moved.vertices[v], no_id);
                continue;
            }
            EXPECT_EQ(complex.position(Vertex{moved.vertices[v]}), before.position(Vertex{v}));
        }
        std::uint32_t smallest_so_far = 0;
        std::vector<std::uint32_t> old_of_new(complex.triangle_bound(), no_id);
        for (std::uint32_t t = 1; t < before.triangle_bound(); ++t) {
            if (!before.is_alive(Triangle{t})) {
                EXPECT_EQ(moved.triangles[t], no_id);
                continue;
            }
            old_of_new[moved.triangles[t]] = t;
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_EQ(complex.triangles[moved.triangles[t]].v[i],
                          moved.vertices[before.triangles[t].v[i]]);
            }
            EXPECT_EQ(complex.triangles[moved.triangles[t]].phase, before.triangles[t].phase);
        }
        for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
            const auto& v = complex.triangles[t].v;
            const std::uint32_t smallest = std::min({v[0], v[1], v[2]});
            EXPECT_GE(smallest, smallest_so_far);
            smallest_so_far = smallest;
            EXPECT_NE(old_of_new[t], no_id);
        }
    }
    EXPECT_GT(free_ids, 0U);
}

TYPED_TEST(Numbering, AttributesAndLocksMoveAlong) {
    auto complex = used<TypeParam>(4);
    auto& x = complex.attributes.template add<Vertex, TypeParam>("x");
    auto& middle = complex.attributes.template add<Triangle, TypeParam>("middle");
    auto& side = complex.attributes.template add<Edge, TypeParam>("side");
    const auto centre = [&](Triangle t) {
        const auto v = complex.vertices_of(t);
        std::array<TypeParam, 3> at{complex.position(v[0]).x(), complex.position(v[1]).x(),
                                    complex.position(v[2]).x()};
        std::sort(at.begin(), at.end());
        return at[0] + at[1] + at[2];
    };
    const auto length = [&](Corner c) {
        return complex.position(Vertex{complex.vertex(next(c))}).x() +
               complex.position(Vertex{complex.vertex(prev(c))}).x();
    };
    const auto each = [&](auto visit_vertex, auto visit_triangle, auto visit_corner) {
        for (const Vertex v : all_simplices(complex).vertices()) {
            visit_vertex(v);
        }
        for (const Triangle t : all_simplices(complex).triangles()) {
            visit_triangle(t);
            for (std::uint32_t i = 0; i < 3; ++i) {
                visit_corner(corner_of(t.id, i));
            }
        }
    };
    each([&](Vertex v) { x[v] = complex.position(v).x(); },
         [&](Triangle t) { middle[t] = centre(t); },
         [&](Corner c) { side.set(complex, complex.edge(c), length(c)); });
    const Vertex locked = *vertices(complex).begin();
    complex.set_locked(locked, true);
    const Renumbering moved = renumber(complex);
    ASSERT_EQ(validate(complex).problem, "");
    EXPECT_EQ(x.data().size(), complex.vertex_bound());
    each([&](Vertex v) { EXPECT_EQ(x[v], complex.position(v).x()); },
         [&](Triangle t) { EXPECT_EQ(middle[t], centre(t)); },
         [&](Corner c) { EXPECT_EQ(side.at_corner(c), length(c)); });
    for (const Vertex v : all_simplices(complex).vertices()) {
        EXPECT_EQ(complex.is_locked(v), v.id == moved.vertices[locked.id]);
    }
    // The bounds have been updated, so the complex can grow and get new attributes.
    insert_vertex(complex, Point<TypeParam>(50, 50));
    complex.attributes.template add<Triangle, double>("late");
    EXPECT_EQ(validate(complex).problem, "");
}

TYPED_TEST(Numbering, DependsOnPositionsAlone) {
    auto one = grid<TypeParam>(16, 0.15, 2, 5);
    auto other = shuffled(one, 77);
    renumber(one);
    renumber(other);
    ASSERT_EQ(one.vertex_bound(), other.vertex_bound());
    for (std::uint32_t v = 0; v < one.vertex_bound(); ++v) {
        EXPECT_EQ(one.position(Vertex{v}), other.position(Vertex{v}));
    }
    for (std::uint32_t t = 1; t < one.triangle_bound(); ++t) {
        auto a = one.triangles[t].v;
        auto b = other.triangles[t].v;
        std::sort(a.begin(), a.end());
        std::sort(b.begin(), b.end());
        EXPECT_EQ(a, b);
        EXPECT_EQ(one.triangles[t].phase, other.triangles[t].phase);
    }
    const auto again = renumber(one);
    for (std::uint32_t v = 0; v < one.vertex_bound(); ++v) {
        EXPECT_EQ(again.vertices[v], v);
    }
    for (std::uint32_t t = 0; t < one.triangle_bound(); ++t) {
        EXPECT_EQ(again.triangles[t], t);
    }
}

TYPED_TEST(Numbering, CopesWithOddExtents) {
    Complex<TypeParam> empty;
    EXPECT_TRUE(renumber(empty).vertices.empty());
    EXPECT_EQ(renumber(empty).triangles.size(), 1U);
    Complex<TypeParam> point;
    insert_vertex(point, Point<TypeParam>(3, 4));
    insert_vertex(point, Point<TypeParam>(3, 4));
    EXPECT_EQ(renumber(point).vertices, (std::vector<std::uint32_t>{0, 1}));
    Complex<TypeParam> wide;
    const TypeParam largest = std::numeric_limits<TypeParam>::max();
    const TypeParam smallest = std::numeric_limits<TypeParam>::denorm_min();
    for (const TypeParam x : {largest, -largest, TypeParam(0), smallest}) {
        insert_vertex(wide, Point<TypeParam>(x, x));
    }
    renumber(wide);
    EXPECT_EQ(validate(wide).problem, "");
    EXPECT_EQ(wide.vertices.front().x, -largest);
    EXPECT_EQ(wide.vertices.back().x, largest);
    Complex<TypeParam> tiny;
    insert_vertex(tiny, Point<TypeParam>(smallest, 0));
    insert_vertex(tiny, Point<TypeParam>(0, 0));
    renumber(tiny);
    EXPECT_EQ(validate(tiny).problem, "");
}

// --- hash ----------------------------------------------------------------------------------------

TYPED_TEST(Hash, DoesNotDependOnIds) {
    const auto complex = grid<TypeParam>(10, 0.15, 2, 3);
    const std::uint64_t hash = mesh_hash(complex);
    for (unsigned seed = 0; seed < 20; ++seed) {
        auto other = shuffled(complex, seed);
        EXPECT_EQ(mesh_hash(other), hash);
        insert_vertex(other, Point<TypeParam>(99, 99));
        remove(other, SimplexSet({insert_vertex(other, Point<TypeParam>(1, 1))}, {}, {}));
        EXPECT_EQ(mesh_hash(other), hash);
    }
    EXPECT_EQ(mesh_hash(Complex<TypeParam>()), mesh_hash(Complex<TypeParam>()));
}

TYPED_TEST(Hash, SeesEveryBit) {
    const auto complex = grid<TypeParam>(4, 0.15, 2, 1);
    std::set<std::uint64_t> seen{mesh_hash(complex)};
    std::size_t changes = 0;
    const auto expect_new = [&](const Complex<TypeParam>& changed) {
        ++changes;
        EXPECT_TRUE(seen.insert(mesh_hash(changed)).second);
    };
    using Bits = std::conditional_t<sizeof(TypeParam) == 8, std::uint64_t, std::uint32_t>;
    for (std::uint32_t v = 0; v < complex.vertex_bound(); ++v) {
        for (unsigned bit = 0; bit < 8 * sizeof(TypeParam) - 12; ++bit) {
            auto changed = complex;
            auto& x = changed.vertices[v].x;
            x = std::bit_cast<TypeParam>(std::bit_cast<Bits>(x) ^ (Bits{1} << bit));
            expect_new(changed);
        }
    }
    for (std::uint32_t t = 1; t < complex.triangle_bound(); ++t) {
        for (unsigned bit = 0; bit < 32; ++bit) {
            auto changed = complex;
            changed.triangles[t].phase ^= 1U << bit;
            expect_new(changed);
        }
        auto turned = complex;
        std::swap(turned.triangles[t].v[0], turned.triangles[t].v[1]);
        expect_new(turned);
        auto fewer = complex;
        remove(fewer, SimplexSet({}, {}, {Triangle{t}}));
        expect_new(fewer);
    }
    EXPECT_EQ(seen.size(), changes + 1);
    // The same positions, another diagonal; x and y exchanged.
    auto mirrored = complex;
    for (auto& vertex : mirrored.vertices) {
        std::swap(vertex.x, vertex.y);
    }
    expect_new(mirrored);
}

TYPED_TEST(Hash, MinusZeroIsZeroAndFloatsAreDoubles) {
    auto complex = grid<TypeParam>(3);
    const std::uint64_t hash = mesh_hash(complex);
    complex.vertices[0].x = -TypeParam(0);
    EXPECT_EQ(mesh_hash(complex), hash);
    EXPECT_EQ(mesh_hash(grid<double>(3)), mesh_hash(grid<float>(3)));
    EXPECT_EQ(hash, mesh_hash(grid<double>(3)));
}

} // namespace
} // namespace dsc::numbering_test
