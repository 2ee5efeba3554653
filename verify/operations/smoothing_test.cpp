// SPDX-License-Identifier: MIT
// Smoothing along the interface, without a change of shape. Inside a phase (equation 6) it is
// compared with the reference (reference/equivalence_test.cpp).
#include "support/operations_testing.h"
#include "support/small_meshes.h"

#include "dsc/base/error.h"
#include "dsc/base/verdict.h"
#include "thesis/operations/smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace dsc::test::smoothing_test {
namespace {

template <class Real>
class Smoothing : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Smoothing, Reals);

auto slide(std::uint32_t v, InterfaceSmoothingOptions options = {}) {
    return [v, options](const auto& submesh) {
        return interface_smoothing(submesh, Vertex{v}, options);
    };
}

// --- along the interface -------------------------------------------------------------------------

// Three rings around the origin, at radius 1 - h, 1 and 1 + h, h = 2 pi / n, stretched in x; the
// inner band has phase 1, the outer one 0. Vertex k of the middle ring is n + k; that at 45 degrees
// is shifted by `shift` h.
template <class Real>
Complex<Real> rings(std::uint32_t n, double shift, double stretch = 1) {
    const double h = 2 * std::numbers::pi / n;
    std::vector<Point<Real>> points;
    for (int ring = -1; ring <= 1; ++ring) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const double angle = h * (i + (ring == 0 && i == n / 8 ? shift : 0));
            const double radius = 1 + ring * h;
            points.emplace_back(static_cast<Real>(stretch * radius * std::cos(angle)),
                                static_cast<Real>(radius * std::sin(angle)));
        }
    }
    std::vector<Indices> triangles;
    std::vector<Phase> phases;
    for (std::uint32_t band = 0; band < 2; ++band) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = band * n + i;
            const std::uint32_t b = band * n + (i + 1) % n;
            triangles.push_back({a, a + n, b});
            triangles.push_back({b, a + n, b + n});
            phases.insert(phases.end(), {1 - band, 1 - band});
        }
    }
    return build<Real>(points, triangles, phases);
}

template <class Real>
double off_curve(const Complex<Real>& K, std::uint32_t v, double stretch = 1) {
    const auto p = K.position(Vertex{v}).template cast<double>().eval();
    return std::abs(std::hypot(p.x() / stretch, p.y()) - 1);
}

template <class Real>
double edge_ratio(const Complex<Real>& K, std::uint32_t a, std::uint32_t v, std::uint32_t b) {
    const double one = static_cast<double>((K.position(Vertex{a}) - K.position(Vertex{v})).norm());
    const double two = static_cast<double>((K.position(Vertex{b}) - K.position(Vertex{v})).norm());
    return one / two;
}

TYPED_TEST(Smoothing, SlidesToEqualLengthsAndKeepsTheShape) {
    for (const double shift : {0.4, -0.4}) {
        for (const double stretch : {1.0, 1.5}) {
            std::vector<double> error;
            for (const std::uint32_t n : {48U, 96U, 192U}) {
                const std::uint32_t k = n + n / 8;
                auto K = rings<TypeParam>(n, shift, stretch);
                expect_valid(K);
                EXPECT_EQ(interface_smoothing(K, Vertex{k}), Verdict::legal) << n;
                expect_valid(K);
                EXPECT_NEAR(edge_ratio(K, k - 1, k, k + 1), 1, 1e-3);
                error.push_back(off_curve(K, k, stretch));
            }
            if (std::is_same_v<TypeParam, double>) {
                // O(h^4) of the four-point curve: halving h divides by 16.
                EXPECT_LT(error[1], error[0] / 11) << shift << ' ' << stretch;
                EXPECT_LT(error[2], error[1] / 11) << shift << ' ' << stretch;
                EXPECT_LT(error[2], 1e-6);
            }
        }
    }
}

TYPED_TEST(Smoothing, TheCurveOfThreePointsWhereTheSubmeshEnds) {
    // The vertex beyond the farther neighbour belongs to another submesh: O(h^3).
    std::vector<double> error;
    for (const std::uint32_t n : {24U, 48U, 96U}) {
        const std::uint32_t k = n + n / 8;
        auto K = rings<TypeParam>(n, 0.4, 1.5); // so k - 1 is the farther neighbour
        auto whole = K;
        std::vector<std::uint32_t> labels(3 * n, 1);
        labels[k - 2] = 0;
        EXPECT_EQ(interface_smoothing(submesh_of(K, labels), Vertex{k}), Verdict::legal);
        expect_valid(K);
        EXPECT_NEAR(edge_ratio(K, k - 1, k, k + 1), 1, 1e-3);
        error.push_back(off_curve(K, k, 1.5));
        EXPECT_EQ(interface_smoothing(whole, Vertex{k}), Verdict::legal);
        EXPECT_NE(K.position(Vertex{k}), whole.position(Vertex{k}));
    }
    if (std::is_same_v<TypeParam, double>) {
        EXPECT_LT(error[1], error[0] / 6);
        EXPECT_LT(error[2], error[1] / 6);
    }
}

TYPED_TEST(Smoothing, StepIsAShareOfTheWay) {
    auto K = rings<TypeParam>(32, 0.4);
    EXPECT_EQ(interface_smoothing(K, Vertex{36}, {.step = 0.5}), Verdict::legal);
    expect_valid(K);
    EXPECT_NEAR(edge_ratio(K, 35, 36, 37), 1.2 / 0.8, 0.01);
}

TYPED_TEST(Smoothing, SlideIsRefused) {
    auto K = rings<TypeParam>(16, 0.4);
    expect_refused(K, Verdict::not_a_simplex, slide(48));
    expect_refused(K, Verdict::on_boundary, slide(2));
    expect_refused(K, Verdict::no_gain, slide(24)); // equal lengths already
    std::vector<std::uint32_t> labels(48, 1);
    labels[2] = 0;
    expect_refused(K, Verdict::on_submesh_boundary, slide(18), labels);
    K.set_locked(Vertex{18}, true);
    expect_refused(K, Verdict::locked, slide(18));
    // A turn of 22.5 degrees is a feature if the options say so.
    expect_refused(K, Verdict::on_interface, slide(18, {.feature_degrees = 10}));
    // A junction: one triangle of a third phase.
    K.set_phase(Triangle{triangle_of(K.vertices[18].corner)}, 7);
    expect_refused(K, Verdict::on_interface, slide(18));
    // A vertex away from the interface.
    auto G = grid<TypeParam>(4);
    expect_refused(G, Verdict::on_interface, slide(12));
}

TYPED_TEST(Smoothing, CornersStayAndNoCurveRunsThroughThem) {
    // A square of phase 1 in the middle of a grid: 24 (3, 3) is one of its corners in 7 x 7
    // vertices.
    auto K = grid<TypeParam>(6, 0, 1);
    for (std::uint32_t t = 1; t < K.triangle_bound(); ++t) {
        const auto [a, b, c] = K.vertices_of(Triangle{t});
        const Point<TypeParam> p = (K.position(a) + K.position(b) + K.position(c)) / TypeParam(3);
        K.set_phase(Triangle{t}, p.x() > 1 && p.x() < 4 && p.y() > 1 && p.y() < 4 ? 1 : 0);
    }
    expect_refused(K, Verdict::on_interface, slide(4 * 7 + 4));
    // (3, 4) lies between (2, 4) and the corner (4, 4). Moved along the straight side, the vertex
    // returns to the middle, exactly on the side, because the curve is not continued around the
    // corner.
    const Vertex v{4 * 7 + 3};
    K.set_position(v, {TypeParam(2.5), 4});
    expect_valid(K);
    EXPECT_EQ(interface_smoothing(K, v), Verdict::legal);
    expect_valid(K);
    EXPECT_EQ(K.position(v).y(), TypeParam(4));
    EXPECT_NEAR(K.position(v).x(), 3, 1e-6);
}

TYPED_TEST(Smoothing, TakesAnglesUpToAHalfTurnAndStepsUpToTheWholeWay) {
    auto complex = grid<TypeParam>(6, 0.1, 1, 2);
    for (const double degrees : {0.0, 0.5, 180.0}) {
        EXPECT_NO_THROW(
            (void)interface_smoothing(complex, Vertex{10}, {.feature_degrees = degrees}));
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const InterfaceSmoothingOptions& bad :
         std::vector<InterfaceSmoothingOptions>{{.feature_degrees = -0.5},
                                                {.feature_degrees = 180.5},
                                                {.feature_degrees = nan},
                                                {.step = 2},
                                                {.step = nan}}) {
        EXPECT_THROW((void)interface_smoothing(complex, Vertex{10}, bad), InputError);
    }
}

// In a star without area, no triangle contains the new position, so fields keep their values.
TYPED_TEST(Smoothing, ResamplesNothingInAStarWithoutArea) {
    auto K = hexagon<TypeParam>();
    auto& field = K.attributes.template add<Vertex>("field", 7.0);
    field.set_field(true);
    for (std::uint32_t v = 0; v < K.vertex_bound(); ++v) {
        K.set_position(Vertex{v}, {TypeParam(0.5), TypeParam(0.5)});
    }
    resample_fields<TypeParam>(K, Vertex{0}, {TypeParam(0.5), TypeParam(0.5)}, false);
    EXPECT_EQ(field[Vertex{0}], 7);
}

} // namespace
} // namespace dsc::test::smoothing_test
