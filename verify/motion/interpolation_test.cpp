// SPDX-License-Identifier: MIT
// The insertion of vertices: on a cubic polynomial in chord length, so of fourth order on smooth
// curves, and linear beside corners.
#include "dsc/motion/interpolation.h"

#include "support/pointwise.h"

#include "dsc/algorithm/simulation.h"
#include "dsc/initial/initial_complex.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace dsc::interpolation_test {
namespace {

using Wide = Eigen::Matrix<long double, 2, 1>;

// The same polynomial by Newton's divided differences, in long double.
Wide newton(const std::vector<Wide>& points, const std::vector<long double>& knots,
            long double at) {
    std::vector<Wide> table = points;
    for (std::size_t order = 1; order < points.size(); ++order) {
        for (std::size_t i = points.size() - 1; i >= order; --i) {
            table[i] = (table[i] - table[i - 1]) / (knots[i] - knots[i - order]);
        }
    }
    Wide value = table.back();
    for (std::size_t i = points.size() - 1; i-- > 0;) {
        value = table[i] + (at - knots[i]) * value;
    }
    return value;
}

template <class Real>
Wide expected_point(const CurveNeighbours<Real>& n, long double share = 0.5L) {
    const auto wide = [](const Point<Real>& p) { return Wide(p.x(), p.y()); };
    std::vector<Wide> points;
    if (n.has_first) {
        points.push_back(wide(n.p0));
    }
    points.push_back(wide(n.p1));
    points.push_back(wide(n.p2));
    if (n.has_last) {
        points.push_back(wide(n.p3));
    }
    std::vector<long double> knots{0};
    for (std::size_t i = 1; i < points.size(); ++i) {
        knots.push_back(knots.back() + (points[i] - points[i - 1]).norm());
    }
    const std::size_t one = n.has_first ? 1 : 0;
    return newton(points, knots, knots[one] + share * (knots[one + 1] - knots[one]));
}

template <class Real>
class Interpolation : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Interpolation, Reals);

TYPED_TEST(Interpolation, IsThePolynomialThroughTheNeighboursByChordLength) {
    using Real = TypeParam;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> jitter(-0.2, 0.2);
    const auto near = [&](double x, double y) {
        return Point<Real>(static_cast<Real>(x + jitter(random)),
                           static_cast<Real>(y + jitter(random)));
    };
    for (int i = 0; i < 500; ++i) {
        CurveNeighbours<Real> n;
        n.p0 = near(0, 0);
        n.p1 = near(1, 0.4);
        n.p2 = near(2, 0.3);
        n.p3 = near(3, -0.3);
        n.has_first = i % 4 != 1;
        n.has_last = i % 4 != 2;
        const Wide expected = expected_point(n);
        const Point<Real> point = insertion_point(Insertion::cubic, n);
        const double rounding = 30.0 * static_cast<double>(std::numeric_limits<Real>::epsilon());
        EXPECT_NEAR(point.x(), static_cast<double>(expected.x()), rounding) << i;
        EXPECT_NEAR(point.y(), static_cast<double>(expected.y()), rounding) << i;
        for (const double share : {0.0, 0.125, 0.75, 1.0}) {
            const Wide there = expected_point(n, share);
            const Point<Real> read = curve_point(n, static_cast<Real>(share));
            EXPECT_NEAR(read.x(), static_cast<double>(there.x()), rounding) << i << " " << share;
            EXPECT_NEAR(read.y(), static_cast<double>(there.y()), rounding) << i << " " << share;
            const std::array<Real, 4> heights{n.p0.y(), n.p1.y(), n.p2.y(), n.p3.y()};
            EXPECT_NEAR(curve_value(n, heights, static_cast<Real>(share)), read.y(), rounding);
        }
    }
}

TYPED_TEST(Interpolation, IsTheMidpointBetweenTwoCorners) {
    using Real = TypeParam;
    CurveNeighbours<Real> n;
    n.p1 = {Real(0.25), Real(1)};
    n.p2 = {Real(0.75), Real(3)};
    // Must not be read.
    n.p0 = n.p3 = Point<Real>::Constant(std::numeric_limits<Real>::quiet_NaN());
    for (const auto insertion : {Insertion::linear, Insertion::cubic}) {
        const Point<Real> point = insertion_point(insertion, n);
        EXPECT_EQ(point.x(), Real(0.5));
        EXPECT_EQ(point.y(), Real(2));
    }
}

// Interface remeshing does not use the neighbour beyond a corner of the outline; elsewhere it does.
TEST(CubicInsertion, DoesNotLookAroundCorners) {
    const std::vector<Point<double>> square{{0.35, 0.35}, {0.65, 0.35}, {0.65, 0.65}, {0.35, 0.65}};
    const std::vector<Shape> shapes{{square, 1}};
    auto complex = initial_complex<double>({}, shapes, {.edge_length = 0.05});
    Options<double> options;
    options.edge_length = 0.05;
    const Point<double> centre(0.5, 0.5);
    double half = 0.15; // of the square's side, as it grows
    const auto is_feature = [&](const Point<double>& p) {
        const Point<double> d = (p - centre).cwiseAbs();
        return d.minCoeff() > half * (1 - 1e-9);
    };
    int around = 0;
    int smooth = 0;
    int cornered = 0;
    options.insertion_function = [&](const CurveNeighbours<double>& n) {
        around += (n.has_first && is_feature(n.p1)) || (n.has_last && is_feature(n.p2)) ? 1 : 0;
        smooth += n.has_first && n.has_last ? 1 : 0;
        cornered += !n.has_first || !n.has_last ? 1 : 0;
        return insertion_point(Insertion::cubic, n);
    };
    Simulation<double> simulation(complex, options);
    const auto grow =
        test::pointwise([&](const Point<double>& p) { return Point<double>(p - centre); });
    for (int step = 0; step < 40; ++step) {
        const auto report = simulation.step(grow, 0, 0.025);
        ASSERT_EQ(report.unreached, 0U);
        ASSERT_EQ(report.sub_steps, 1U);
        double corner = 0;
        for (const std::uint32_t v : simulation.interface()) {
            const Point<double> d = (complex.position(Vertex{v}) - centre).cwiseAbs();
            corner = std::max(corner, d.minCoeff());
        }
        half = corner;
    }
    EXPECT_EQ(around, 0);
    EXPECT_GT(smooth, 10);
    EXPECT_GE(cornered, 4);
    // The square must keep its shape.
    for (const std::uint32_t v : simulation.interface()) {
        const Point<double> d = (complex.position(Vertex{v}) - centre).cwiseAbs();
        EXPECT_NEAR(d.maxCoeff(), half, 1e-9);
    }
}

} // namespace
} // namespace dsc::interpolation_test
