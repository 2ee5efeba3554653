// SPDX-License-Identifier: MIT
// The meter of the mesh on meshes whose faults are known: it must not say that all is well.
#include "measures/mesh_quality.h"

#include "dsc/quality/measures.h"
#include "support/small_meshes.h"

#include <gtest/gtest.h>

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

} // namespace

} // namespace dsc::scenes::mesh_quality_test
