// SPDX-License-Identifier: MIT
// Components of phases on grids, and on random complexes against a literal computation.
#include "support/random/complex.h"
#include "support/small_meshes.h"

#include "dsc/geometry/triangle.h"
#include "dsc/queries/phases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace dsc::test::components_test {
namespace {

// A grid of squares with the phases of `rows`, from the lowest row on.
Complex<double> chequered(const std::vector<std::string>& rows) {
    auto K = grid<double>(static_cast<std::uint32_t>(rows.size()));
    for (const Triangle t : triangles(K)) {
        const std::size_t square = (t.id - 1) / 2;
        const char symbol = rows[square / rows.size()][square % rows.size()];
        K.set_phase(t, static_cast<Phase>(symbol - '0'));
    }
    return K;
}

std::vector<Component> of_phase(const Complex<double>& K, Phase phase) {
    std::vector<Component> list = components(K).list;
    std::erase_if(list, [&](const Component& one) { return one.phase != phase; });
    return list;
}

TEST(Components, AreSeparateUnlessTheyShareAnEdge) {
    const auto K = chequered({"00000", //
                              "01020", //
                              "00100", //
                              "00110", //
                              "00000"});
    const auto ones = of_phase(K, 1);
    ASSERT_EQ(ones.size(), 2U);
    EXPECT_EQ(ones[0].triangles, 2U);
    EXPECT_EQ(ones[1].triangles, 6U);
    EXPECT_DOUBLE_EQ(ones[1].area, 3);
    EXPECT_EQ(ones[1].outlines, 1U);
    EXPECT_FALSE(ones[1].touches_border);
    ASSERT_EQ(of_phase(K, 2).size(), 1U);
    const auto exterior = of_phase(K, 0);
    ASSERT_EQ(exterior.size(), 1U);
    EXPECT_TRUE(exterior[0].touches_border);
    EXPECT_DOUBLE_EQ(exterior[0].area, 25 - 5);
    // All three touch each other at vertices, so they leave one hole.
    EXPECT_EQ(exterior[0].holes(), 1U);
}

// Computes components literally. If each fan of triangles around a vertex counts as a vertex of its
// own, a component is a surface in the plane, so the number of its holes follows from Euler's
// formula.
void compare_with_literal(const Complex<double>& K) {
    const Components found = components(K);
    std::vector<std::uint32_t> name(K.triangle_bound());
    std::iota(name.begin(), name.end(), 0U);
    const auto neighbours = [&](std::uint32_t t, auto visit) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner across = K.twin(corner_of(t, i));
            if (!is_border(across) && K.phase_at(across) == K.phase(Triangle{t})) {
                visit(triangle_of(across), i);
            }
        }
    };
    for (bool changed = true; changed;) { // the smallest id spreads
        changed = false;
        for (const Triangle t : triangles(K)) {
            neighbours(t.id, [&](std::uint32_t other, std::uint32_t) {
                if (name[other] < name[t.id]) {
                    name[t.id] = name[other];
                    changed = true;
                }
            });
        }
    }
    std::map<std::uint32_t, int> euler;
    std::map<std::uint32_t, double> area_of;
    for (const Triangle t : triangles(K)) {
        const std::uint32_t here = name[t.id];
        euler[here] += 1 - 3;
        neighbours(t.id, [&](std::uint32_t, std::uint32_t i) {
            const Corner c = corner_of(t.id, i);
            euler[here] += c < K.twin(c) ? 1 : 0; // an edge that was counted twice
        });
        const auto [a, b, c] = K.vertices_of(t);
        area_of[here] += area<double>(K.position(a), K.position(b), K.position(c));
    }
    for (const Vertex v : vertices(K)) {
        // A fan of triangles of one phase begins where the clockwise neighbour has another phase;
        // otherwise one fan surrounds the vertex.
        bool all_around = true;
        std::uint32_t last = no_id;
        for_each_corner(K, v, [&](Corner c) {
            const Corner cw = K.twin(prev(c));
            last = triangle_of(c);
            if (K.phase_at(cw) != K.phase_at(c)) {
                ++euler[name[last]];
                all_around = false;
            }
        });
        if (all_around && last != no_id) {
            ++euler[name[last]];
        }
    }
    ASSERT_EQ(found.list.size(), euler.size());
    std::uint32_t number = 0;
    for (const auto& [smallest, characteristic] : euler) {
        const Component& component = found.list[number];
        EXPECT_EQ(1 - characteristic, static_cast<int>(component.holes()));
        EXPECT_NEAR(component.area, area_of[smallest], 1e-9 * (1 + area_of[smallest]));
        for (const Triangle t : triangles(K)) {
            EXPECT_EQ(found.of[t.id] == number, name[t.id] == smallest);
        }
        ++number;
    }
}

TEST(Components, AreThoseOfALiteralComputation) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        RandomComplexOptions options = random_options(seed, 60);
        options.at_resolution = false;
        compare_with_literal(random_complex<double>(seed, options));
        ASSERT_FALSE(testing::Test::HasFailure());
    }
}

} // namespace
} // namespace dsc::test::components_test
