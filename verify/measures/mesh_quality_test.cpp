// SPDX-License-Identifier: MIT
// The meter of the mesh on meshes whose faults are known: it must not say that all is well.
#include "measures/mesh_quality.h"

#include "dsc/complex/ranges.h"
#include "dsc/geometry/predicates.h"
#include "dsc/quality/measures.h"
#include "support/small_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace dsc::scenes::mesh_quality_test {
namespace {

TEST(MeshQuality, CountsTrianglesThatAreTurnedOver) {
    auto complex = test::hexagon<double>();
    EXPECT_EQ(measure_worst(complex).inverted, 0U);
    complex.set_position(Vertex{0}, {1.5, 0}); // beyond the edges on the right
    const MeshQuality quality = measure_quality(complex);
    EXPECT_EQ(quality.inverted, 2U);
    EXPECT_LT(quality.min_quality, 0);
}

TEST(MeshQuality, CountsTrianglesWithoutArea) {
    auto complex = test::hexagon<double>();
    complex.set_position(Vertex{0}, complex.position(Vertex{1}));
    EXPECT_EQ(measure_worst(complex).inverted, 2U);
}

TEST(MeshQuality, IsThatOfTheWorstTriangleWhereverItIs) {
    for (std::uint32_t worst = 1; worst <= 6; ++worst) {
        auto complex = test::hexagon<double>();
        const Triangle flat{worst};
        const auto v = complex.vertices_of(flat);
        const Point<double> middle =
            midpoint<double>(complex.position(v[1]), complex.position(v[2]));
        complex.set_position(Vertex{0}, 0.9 * middle);
        const MeshQuality quality = measure_quality(complex);
        EXPECT_EQ(quality.min_quality, dsc::quality(complex, flat));
        EXPECT_LT(quality.min_quality, 0.3);
        EXPECT_NEAR(quality.min_angle_deg, min_angle_deg(complex, flat), 1e-4);
    }
}

// Most triangles are passed over by a bound: the answer is that of a look at each, to the bit.
template <class Real>
void expect_a_look_at_each(double size, std::uint32_t seed) {
    auto complex = test::hexagon<Real>();
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> away(-1.1, 1.1);
    for (int i = 0; i < 3000; ++i) {
        // Near an edge or a vertex now and then, and now and then on it.
        const double nearness = i % 3 == 0 ? 1e-9 * away(random) : away(random);
        const double along = i % 5 == 0 ? 1 : away(random);
        const auto v = static_cast<std::uint32_t>(random() % 7);
        auto moved = complex;
        moved.set_position(Vertex{0}, {static_cast<Real>(along), static_cast<Real>(nearness)});
        for (std::uint32_t j = 0; j < 7; ++j) {
            const Point<Real> p = moved.position(Vertex{j});
            const Real scale = static_cast<Real>(j == v ? size * (1 + nearness) : size);
            moved.set_position(Vertex{j}, scale * p);
        }
        MeshQuality expected;
        for (const Triangle t : triangles(moved)) {
            const auto p = moved.vertices_of(t);
            expected.inverted += orientation<Real>(moved.position(p[0]), moved.position(p[1]),
                                                   moved.position(p[2])) > 0
                                     ? 0U
                                     : 1U;
            expected.min_quality =
                std::min(expected.min_quality, static_cast<double>(dsc::quality(moved, t)));
        }
        const MeshQuality found = measure_worst(moved);
        ASSERT_EQ(found.min_quality, expected.min_quality) << "size " << size << ", mesh " << i;
        ASSERT_EQ(found.inverted, expected.inverted) << "size " << size << ", mesh " << i;
    }
}

TEST(MeshQuality, IsThatOfALookAtEachTriangle) {
    for (const double size : {1.0, 1e-3, 1e-60, 1e-75, 1e60}) {
        expect_a_look_at_each<double>(size, 1);
    }
    for (const double size : {1.0, 1e-3, 1e-15}) {
        expect_a_look_at_each<float>(size, 2);
    }
}

} // namespace

} // namespace dsc::scenes::mesh_quality_test
