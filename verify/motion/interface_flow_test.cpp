// SPDX-License-Identifier: MIT
// Normals, curvature and lengths of curves that are known only by their vertices.
#include "dsc/motion/interface_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace dsc::interface_flow_test {
namespace {

// One closed curve of phase 1 in phase 0.
template <class Real>
struct Polygon {
    explicit Polygon(std::vector<Point<Real>> points)
        : positions(std::move(points)), vertices(positions.size()), previous(positions.size()),
          next(positions.size()), left(positions.size(), 1), right(positions.size(), 0),
          flags(positions.size(), 0) {
        for (std::uint32_t i = 0; i < positions.size(); ++i) {
            const auto n = static_cast<std::uint32_t>(positions.size());
            vertices[i] = Vertex{i};
            previous[i] = (i + n - 1) % n;
            next[i] = (i + 1) % n;
        }
    }
    [[nodiscard]] InterfaceView<Real> view() const {
        return {.complex = complex,
                .vertices = vertices,
                .positions = positions,
                .previous = previous,
                .next = next,
                .left = left,
                .right = right,
                .flags = flags,
                .junctions = {},
                .arm_begin = {},
                .arms = {}};
    }

    Complex<Real> complex;
    std::vector<Point<Real>> positions;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> previous;
    std::vector<std::uint32_t> next;
    std::vector<Phase> left;
    std::vector<Phase> right;
    std::vector<std::uint8_t> flags;
};

// Parameters from 0 to 1 whose steps differ by up to three times.
std::vector<double> uneven(int n) {
    std::vector<double> parameters;
    for (int i = 0; i < n; ++i) {
        const double t = static_cast<double>(i) / n;
        parameters.push_back(t + 0.5 * std::sin(6 * std::numbers::pi * t) / (6 * std::numbers::pi));
    }
    return parameters;
}

template <class Real>
Polygon<Real> ellipse(double a, double b, int n, double scale = 1) {
    std::vector<Point<Real>> points;
    for (const double t : uneven(n)) {
        const double angle = 2 * std::numbers::pi * t;
        points.emplace_back(static_cast<Real>(scale * a * std::cos(angle)),
                            static_cast<Real>(scale * b * std::sin(angle)));
    }
    return Polygon<Real>(std::move(points));
}

template <class Real>
class InterfaceFlows : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(InterfaceFlows, Reals);

TYPED_TEST(InterfaceFlows, CirclesAreExact) {
    using Real = TypeParam;
    const double smallest = std::is_same_v<Real, float> ? 1e-5 : 1e-50;
    for (const double scale : {smallest, 1.0, 1 / smallest}) {
        const auto circle = ellipse<Real>(1, 1, 24, scale);
        const auto view = circle.view();
        const double rounding = 200 * static_cast<double>(std::numeric_limits<Real>::epsilon());
        for (std::size_t i = 0; i < view.size(); ++i) {
            const Point<double> outwards = circle.positions[i].template cast<double>() / scale;
            const Point<double> n = normal(view, i).template cast<double>();
            EXPECT_LT((n - outwards).norm(), rounding);
            EXPECT_NEAR(static_cast<double>(curvature(view, i)) * scale, 1, rounding);
        }
    }
}

// The largest errors of the normal and of the curvature.
struct Errors {
    double normal = 0;
    double curvature = 0;
};
Errors errors_of(int n) {
    const double a = 1;
    const double b = 0.6;
    const auto curve = ellipse<double>(a, b, n);
    const auto view = curve.view();
    Errors errors;
    for (std::size_t i = 0; i < view.size(); ++i) {
        const Point<double>& p = view.positions[i];
        const Point<double> gradient(p.x() / (a * a), p.y() / (b * b));
        const double exact = 1 / (a * a * b * b * std::pow(gradient.norm(), 3));
        errors.normal = std::max(errors.normal, (normal(view, i) - gradient.normalized()).norm());
        errors.curvature = std::max(errors.curvature, std::abs(curvature(view, i) - exact));
    }
    return errors;
}

TEST(InterfaceFlow, NormalsAreOfSecondOrderAndCurvatureOfFirst) {
    const Errors coarse = errors_of(200);
    const Errors fine = errors_of(400);
    EXPECT_NEAR(std::log2(coarse.normal / fine.normal), 2, 0.1);
    EXPECT_GT(std::log2(coarse.curvature / fine.curvature), 0.9);
    EXPECT_LT(fine.normal, 1e-3);
    EXPECT_LT(fine.curvature, 0.05);
}

TEST(InterfaceFlow, LengthsAddUpToTheWhole) {
    const auto curve = ellipse<double>(1, 0.6, 50);
    const auto view = curve.view();
    double sum = 0;
    double perimeter = 0;
    for (std::size_t i = 0; i < view.size(); ++i) {
        sum += length(view, i);
        perimeter += (view.positions[view.next[i]] - view.positions[i]).norm();
    }
    EXPECT_NEAR(sum, perimeter, 1e-14 * perimeter);
}

TEST(InterfaceFlow, WhereNeighboursCoincideThereIsNoNormal) {
    Polygon<double> curve({{0, 0}, {1, 0}, {1, 0}, {0.5, 1}});
    EXPECT_EQ(normal(curve.view(), 1), Point<double>(0, 0));
    EXPECT_EQ(normal(curve.view(), 2), Point<double>(0, 0));
    EXPECT_EQ(curvature(curve.view(), 1), 0);
    // A curve that folds back onto itself does not define a circle either.
    Polygon<double> spike({{0, 0}, {1, 0}, {0, 0}, {-1, 0}});
    EXPECT_EQ(normal(spike.view(), 1), Point<double>(0, 0));
}

TEST(InterfaceFlow, OfOneVertexFillsItsRange) {
    const auto curve = ellipse<double>(1, 1, 10);
    const InterfaceFlow<double> flow =
        vertex_flow<double>([](const auto& view, std::size_t i, double time) -> Point<double> {
            return time * normal(view, i);
        });
    std::vector<Point<double>> velocities(10, Point<double>(7, 7));
    flow(curve.view(), 3, 5, 2.0, velocities);
    EXPECT_EQ(velocities[2], Point<double>(7, 7));
    EXPECT_EQ(velocities[5], Point<double>(7, 7));
    EXPECT_LT((velocities[3] - 2 * curve.positions[3]).norm(), 1e-12);
    EXPECT_LT((velocities[4] - 2 * curve.positions[4]).norm(), 1e-12);
}

} // namespace
} // namespace dsc::interface_flow_test
