// SPDX-License-Identifier: MIT
// Vertex attributes that are samples of a field: smoothing gives them the value of the new place.
#include "support/courses.h"

#include "dsc/complex/ranges.h"
#include "dsc/operations/smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace dsc::fields_test {
namespace {

double plane_at(const Point<double>& p) { return 3 + p.x() - 2 * p.y(); }

// A linear field is interpolated exactly.
TEST(Fields, FollowSmoothingAndOtherAttributesDoNot) {
    Complex<double> complex = test::disc();
    auto& field = complex.attributes.add<Vertex, double>("field");
    auto& label = complex.attributes.add<Vertex, double>("label");
    EXPECT_FALSE(field.is_field());
    EXPECT_FALSE(complex.attributes.has_fields());
    field.set_field(true);
    EXPECT_TRUE(complex.attributes.has_fields());
    int smoothed = 0;
    for (const Vertex v : vertices(complex)) {
        const Point<double> off(0.25 * test::disc_h * std::cos(v.id), 0.25 * test::disc_h);
        complex.set_position(v, complex.position(v) + off);
        for (const Vertex w : vertices(complex)) {
            field[w] = plane_at(complex.position(w));
            label[w] = w.id;
        }
        if (laplacian_smoothing(complex, v) == Verdict::legal) {
            ++smoothed;
            ASSERT_NEAR(field[v], plane_at(complex.position(v)), 1e-13);
            ASSERT_EQ(label[v], v.id);
        }
        if (smoothed == 40) {
            return;
        }
    }
    FAIL() << "only " << smoothed << " were smoothed";
}

TEST(Fields, AreFieldsInCopiesToo) {
    Complex<double> complex = test::disc();
    complex.attributes.add<Vertex, double>("field").set_field(true);
    const Complex<double> copy = complex;
    EXPECT_TRUE(copy.attributes.has_fields());
    EXPECT_TRUE(complex.attributes.clone_empty().has_fields());
    EXPECT_EQ((std::as_const(complex).attributes.get<Vertex, double>("field").size()),
              complex.vertex_bound());
}

} // namespace
} // namespace dsc::fields_test
