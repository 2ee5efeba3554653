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
void expect_a_look_at_each(double size) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> away(-1.1, 1.1);
    for (int i = 0; i < 3000; ++i) {
        auto moved = test::hexagon<Real>();
        // Near an edge or a vertex now and then, and now and then on it.
        moved.set_position(Vertex{0}, {static_cast<Real>(i % 5 == 0 ? 1 : away(random)),
                                       static_cast<Real>((i % 3 == 0 ? 1e-9 : 1) * away(random))});
        MeshQuality expected;
        for (std::uint32_t v = 0; v < 7; ++v) {
            moved.set_position(Vertex{v}, static_cast<Real>(size) * moved.position(Vertex{v}));
        }
        for (const Triangle t : triangles(moved)) {
            const auto [a, b, c] = moved.positions_of(t);
            expected.inverted += orientation<Real>(a, b, c) > 0 ? 0U : 1U;
            expected.min_quality =
                std::min(expected.min_quality, static_cast<double>(dsc::quality(moved, t)));
        }
        ASSERT_EQ(measure_worst(moved).min_quality, expected.min_quality) << size << ", " << i;
        ASSERT_EQ(measure_worst(moved).inverted, expected.inverted) << size << ", " << i;
    }
}

TEST(MeshQuality, IsThatOfALookAtEachTriangle) {
    for (const double size : {1.0, 1e-3, 1e-60, 1e-75, 1e60}) {
        expect_a_look_at_each<double>(size);
    }
    for (const double size : {1.0, 1e-3, 1e-15}) {
        expect_a_look_at_each<float>(size);
    }
}

} // namespace

} // namespace dsc::scenes::mesh_quality_test
