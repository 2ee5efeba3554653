// SPDX-License-Identifier: MIT
// First complexes of domains that are no rectangles.
#include "dsc/dsc.h"

#include "support/curve_testing.h"
#include "support/refusal.h"

#include <gtest/gtest.h>

#include <numbers>

namespace dsc::polygon_test {
namespace {

using std::numbers::pi;
using Points = std::vector<Point<double>>;

Points circle(const Point<double>& centre, double radius, int n) {
    Points points;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * pi * i / n;
        points.emplace_back(centre.x() + radius * std::cos(angle),
                            centre.y() + radius * std::sin(angle));
    }
    return points;
}

Points turned(Points points, double angle) {
    for (Point<double>& p : points) {
        p = {std::cos(angle) * p.x() - std::sin(angle) * p.y(),
             std::sin(angle) * p.x() + std::cos(angle) * p.y()};
    }
    return points;
}

const Points l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

double area_of(const Points& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        sum += cross<double>(ring[i], ring[(i + 1) % ring.size()]) / 2;
    }
    return std::abs(sum);
}

template <class Real>
double area_of(const Complex<Real>& complex) {
    double sum = 0;
    for (const Phase phase : phases(complex)) {
        sum += phase_area(complex, phase);
    }
    return sum;
}

struct Case {
    const char* name;
    Polygon domain;
};

std::vector<Case> cases() {
    return {{"disc", {circle({0, 0}, 1, 200)}},
            {"ring", {circle({0, 0}, 1, 200), {circle({0, 0}, 0.4, 80)}}},
            {"L", {l_shape}},
            {"turned rectangle", {turned({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 0.3)}},
            {"two parts", {circle({0, 0}, 1, 200), {circle({3, 0}, 0.8, 160)}}}};
}

double area_of(const Polygon& domain) {
    double sum = area_of(domain.outline);
    for (const Points& ring : domain.holes) {
        sum += ring[0].x() > 2 ? area_of(ring) : -area_of(ring);
    }
    return sum;
}

TEST(PolygonDomain, HasTheAreaAndTheVerticesOfItsRings) {
    for (const Case& one : cases()) {
        SCOPED_TRACE(one.name);
        const std::vector<Shape> none;
        const auto complex = initial_complex<double>(one.domain, none, {.edge_length = 0.05});
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_NEAR(area_of(complex), area_of(one.domain), 1e-12);
        EXPECT_GT(test::smallest_angle(complex), 25);
        for (const Point<double>& p : one.domain.outline) {
            EXPECT_NE(std::ranges::find_if(vertices(complex),
                                           [&](Vertex v) { return complex.position(v) == p; }),
                      vertices(complex).end());
        }
    }
}

// Clips a half-plane of phase 1, which reaches beyond every domain.
TEST(PolygonDomain, ShapesAreClippedAtItsBoundary) {
    const std::vector<Shape> shapes{{{{-9, -9}, {9, -9}, {9, 0.3}, {-9, 0.3}}, 1}};
    const double segment = std::acos(0.3) - 0.3 * std::sqrt(1 - 0.09); // of the disc, above
    const auto below = [&](std::size_t i) {
        const Polygon domain = cases()[i].domain;
        return phase_area(initial_complex<double>(domain, shapes, {.edge_length = 0.05}), 1);
    };
    EXPECT_NEAR(below(0), pi - segment, 1e-3);
    EXPECT_NEAR(below(2), 0.6, 1e-12);
}

// Shapes share borders that cross the domain boundary; both shapes have an edge of their own along
// a border.
TEST(PolygonDomain, SharedBordersMayCrossTheBoundary) {
    for (int seed = 0; seed < 20; ++seed) {
        const Point<double> middle(0.1 + 0.013 * seed, 0.3 - 0.007 * seed);
        std::vector<Shape> sectors;
        for (int i = 0; i < 7; ++i) {
            const auto at = [&](int k) {
                const double angle = 2 * pi * (k % 7) / 7 + 0.1 * seed;
                return Point<double>(middle.x() + 5 * std::cos(angle),
                                     middle.y() + 5 * std::sin(angle));
            };
            sectors.push_back({{middle, at(i), at(i + 1)}, static_cast<Phase>(i + 1)});
        }
        const Polygon domain{circle({0, 0}, 1, 150), {circle({-0.4, 0.1}, 0.2, 40)}};
        const auto complex = initial_complex<double>(domain, sectors, {.edge_length = 0.06});
        EXPECT_EQ(validate(complex).problem, "");
        EXPECT_EQ(phases(complex).size(), 7U);
        EXPECT_NEAR(area_of(complex), area_of(domain), 1e-4);
    }
}

TEST(PolygonDomain, WorksInFloatAndWithEdgesThatGrow) {
    const Polygon domain = cases()[1].domain;
    const std::vector<Shape> shapes{{circle({0.7, 0.1}, 0.5, 100), 1}};
    const auto single = initial_complex<float>(domain, shapes, {.edge_length = 0.05});
    EXPECT_NEAR(area_of(single), area_of(domain), 1e-3);
    InitialOptions graded{.edge_length = 0.02};
    graded.sizes.growth = 1.3;
    const auto coarse = initial_complex<double>(domain, shapes, graded);
    EXPECT_EQ(validate(coarse).problem, "");
    EXPECT_NEAR(area_of(coarse), area_of(domain), 1e-3);
}

TEST(PolygonDomain, RefusesWhatIsNone) {
    const auto expect = [](const Polygon& domain, const std::vector<Shape>& shapes,
                           const std::string& where, const std::string& words) {
        test::expect_refusal(
            [&] { (void)initial_complex<double>(domain, shapes, {.edge_length = 0.1}); }, where,
            words);
    };
    expect({{{0, 0}, {1, 0}}}, {}, "points of the outline of the domain", "3 or more");
    expect({{{0, 0}, {2, 0}, {0, 1}, {2, 1}}}, {}, "the outline of the domain, edge 1", "cross");
    expect({l_shape, {circle({1, 1}, 0.3, 20)}}, {}, "domain", "touch each other");
    expect({{{0, 0}, {1, 0}, {1, 0.05}, {0, 0.05}}}, {}, "edge_length", "smaller side");
    expect({l_shape}, {{circle({0.5, 0.5}, 0.2, 20), border_phase}}, "shape 0", "reserved");
}

} // namespace
} // namespace dsc::polygon_test
