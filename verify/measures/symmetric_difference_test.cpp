// SPDX-License-Identifier: MIT
// All other tests rely on these measures, so they are checked against closed forms, against slower
// methods that share no code with them, and for degenerate inputs.
#include "dsc/base/error.h"
#include "measures/symmetric_difference.h"
#include "shapes/shapes.h"
#include "support/outline_testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace dsc::scenes::symmetric_difference_test {
namespace {

using test::random_star;
using test::square;
using test::transformed;
using test::uniform;
using Random = std::mt19937_64;

OverlapAreas areas_of(const Outline& p, const Outline& q, FillRule rule = FillRule::even_odd) {
    return overlap_areas({std::span(&p, 1), rule}, {std::span(&q, 1), rule});
}

Outline transposed(Outline outline) {
    for (Point<double>& p : outline) {
        std::swap(p.x(), p.y());
    }
    return reversed(std::move(outline));
}

double cross(const Point<double>& a, const Point<double>& b) {
    return a.x() * b.y() - a.y() * b.x();
}

bool even_odd_inside(const Point<double>& p, const Outline& outline) {
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point<double>& a = outline[i];
        const Point<double>& b = outline[(i + 1) % outline.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
            inside = !inside;
        }
    }
    return inside;
}

/// Cuts every edge of `of` at all edges of both outlines, O(n^2), and adds the pieces that bound
/// the difference. Only for simple outlines in general position.
double half_of_difference(const Outline& of, const Outline& other) {
    double doubled = 0.0;
    for (std::size_t i = 0; i < of.size(); ++i) {
        const Point<double>& a = of[i];
        const Point<double> d = of[(i + 1) % of.size()] - a;
        std::vector<double> cuts{0.0, 1.0};
        for (std::size_t j = 0; j < other.size(); ++j) {
            const Point<double>& c = other[j];
            const Point<double> e = other[(j + 1) % other.size()] - c;
            const double det = cross(d, e);
            const double s = cross(c - a, e) / det;
            const double t = cross(c - a, d) / det;
            if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) {
                cuts.push_back(s);
            }
        }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const Point<double> from = a + cuts[k] * d;
            const Point<double> to = a + cuts[k + 1] * d;
            doubled += (even_odd_inside(0.5 * (from + to), other) ? -1.0 : 1.0) * cross(from, to);
        }
    }
    return 0.5 * doubled;
}

double brute_force_difference(const Outline& p, const Outline& q) {
    return half_of_difference(p, q) + half_of_difference(q, p);
}

TEST(SymmetricDifference, ShiftedSquaresInClosedForm) {
    for (const double shift : {0.5, 1e-3, 1e-9, 1e-12}) {
        const Outline first = square(0.0, 0.0, 1.0);
        for (const auto& [dx, dy] : {std::pair(shift, 0.0), {0.0, shift}, {shift, shift}}) {
            const Outline second = transformed(first, 1.0, {dx, dy});
            const double x = second[0].x();
            const double y = second[0].y();
            EXPECT_NEAR(symmetric_difference(first, second), 2.0 * (x + y - x * y), 4e-16);
        }
    }
    const OverlapAreas apart = areas_of(square(0, 0, 1), square(5, 0, 2));
    EXPECT_EQ(apart.only_first, 1.0);
    EXPECT_EQ(apart.only_second, 4.0);
    EXPECT_EQ(apart.both, 0.0);
}

TEST(SymmetricDifference, CrossingsOfNearlyVerticalSides) {
    // Two parallelograms that lean to either side: their sides cross within a strip of width w.
    for (const double w : {0.25, 1e-3, 1e-6, 1e-9, 1e-12}) {
        const Outline right{{0, 0}, {1, 0}, {1 + w, 1}, {w, 1}};
        const Outline left{{w, 0}, {1 + w, 0}, {1, 1}, {0, 1}};
        EXPECT_NEAR(symmetric_difference(right, left), w, 5e-16);
        EXPECT_NEAR(symmetric_difference(transposed(right), transposed(left)), w, 5e-16);
    }
}

TEST(SymmetricDifference, AgreesWithBruteForceOnRandomStars) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Outline p = random_star(random, 3 + i % 60);
        const Outline q = transformed(random_star(random, 3 + (7 * i) % 50), 0.9, {0.05, -0.03});
        const OverlapAreas areas = areas_of(p, q);
        EXPECT_NEAR(areas.symmetric_difference(), brute_force_difference(p, q), 3e-14);
        EXPECT_NEAR(areas.only_first + areas.both, signed_area(p), 1e-14);
        EXPECT_NEAR(areas.only_second + areas.both, signed_area(q), 1e-14);
    }
}

TEST(SymmetricDifference, NearlyCoincidentCurvesKeepTheirDigits) {
    // Noise at each vertex, down to 1e-7 edge lengths, so that the outlines cross everywhere.
    Random random(3);
    for (const double noise : {1e-3, 1e-6, 1e-9}) {
        const Outline p = circle({0.1, 0.2}, 0.7, 0.012);
        Outline q = p;
        for (Point<double>& v : q) {
            v += noise * Point<double>{uniform(random, -1, 1), uniform(random, -1, 1)};
        }
        const double expected = brute_force_difference(p, q);
        EXPECT_NEAR(symmetric_difference(p, q), expected, 1e-6 * noise + 1e-14);
        EXPECT_GT(expected, noise);
    }
    // Moved outwards by 1e-9 all around: the perimeter times 1e-9.
    const Outline p = circle({0.0, 0.0}, 0.7, 0.001);
    const Outline q = transformed(p, 1.0 + 1e-9 / 0.7, {0.0, 0.0});
    EXPECT_NEAR(symmetric_difference(p, q), perimeter(p) * 1e-9, 1e-15);
}

TEST(SymmetricDifference, SliverOfOnePartInTenToTheFourteen) {
    const Outline p = circle({0.5, 0.75}, 0.15, 0.0196);
    for (const std::size_t i : {0U, 5U, 12U, 24U, 31U}) {
        Outline q = p;
        q[i] = Point<double>{0.5, 0.75} + (1.0 + 3e-13) * (p[i] - Point<double>{0.5, 0.75});
        const Point<double>& before = p[(i + p.size() - 1) % p.size()];
        const double sliver = 0.5 * std::abs(cross(q[i] - p[i], p[(i + 1) % p.size()] - before));
        ASSERT_LT(sliver, 2e-14 * signed_area(p));
        EXPECT_NEAR(symmetric_difference(p, q), sliver, 0.02 * sliver) << i;
        const OverlapAreas areas = areas_of(p, q);
        EXPECT_LT(areas.only_first, 0.02 * sliver) << "pushed outwards: nothing was lost";
    }
}

TEST(SymmetricDifference, DegenerateGridPolygonsAgreeWithTheirTransposes) {
    // Vertices on a 5 x 5 grid: shared and overlapping edges, touching vertices, self-crossings.
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        std::array<Outline, 2> outlines;
        for (Outline& outline : outlines) {
            const int count = 3 + static_cast<int>(random() % 8);
            for (int k = 0; k < count; ++k) {
                outline.emplace_back(static_cast<double>(random() % 5),
                                     static_cast<double>(random() % 5));
            }
        }
        const std::array<Outline, 2> mirrored{transposed(outlines[0]), transposed(outlines[1])};
        for (const FillRule rule : {FillRule::even_odd, FillRule::nonzero}) {
            const OverlapAreas one = areas_of(outlines[0], outlines[1], rule);
            const OverlapAreas two = areas_of(mirrored[0], mirrored[1], rule);
            const OverlapAreas swapped = areas_of(outlines[1], outlines[0], rule);
            EXPECT_NEAR(one.only_first, two.only_first, 1e-14);
            EXPECT_NEAR(one.only_second, two.only_second, 1e-14);
            EXPECT_NEAR(one.both, two.both, 1e-14);
            EXPECT_NEAR(one.only_first, swapped.only_second, 1e-14);
        }
    }
}

TEST(SymmetricDifference, HolesAndFillRules) {
    const std::vector<Outline> ring{square(0, 0, 3), reversed(square(1, 1, 1))};
    const std::vector<Outline> full{square(0, 0, 3)};
    const std::vector<Outline> none;
    EXPECT_EQ(symmetric_difference(ring, full), 1.0);
    EXPECT_EQ(symmetric_difference(ring, none), 8.0);
    EXPECT_EQ(symmetric_difference(none, none), 0.0);
    const std::vector<Outline> stacked{square(0, 0, 3), square(1, 1, 1)};
    EXPECT_EQ(overlap_areas({stacked, FillRule::even_odd}, {full}).only_second, 1.0);
    EXPECT_EQ(overlap_areas({stacked, FillRule::nonzero}, {full}).only_second, 0.0);
    EXPECT_EQ(overlap_areas({ring, FillRule::nonzero}, {full}).only_second, 1.0);
    EXPECT_THROW((void)symmetric_difference({{0, 0}, {1, 0}}, square(0, 0, 1)), InputError);
    EXPECT_THROW((void)symmetric_difference({{0, 0}, {1, 0}, {INFINITY, 1}}, square(0, 0, 1)),
                 InputError);
}

TEST(SymmetricDifference, FollowsOffsetAndScale) {
    Random random(6);
    Outline p = random_star(random, 50);
    Outline q = random_star(random, 50);
    for (Outline* outline : {&p, &q}) {
        for (Point<double>& v : *outline) {
            v = {std::round(std::ldexp(v.x(), 20)) * 0x1p-20,
                 std::round(std::ldexp(v.y(), 20)) * 0x1p-20};
        }
    }
    const double area = symmetric_difference(p, q);
    const Point<double> offset{0x1p31, -0x1p30};
    EXPECT_NEAR(symmetric_difference(transformed(p, 1.0, offset), transformed(q, 1.0, offset)),
                area, 1e-14);
    const Point<double> none{0.0, 0.0};
    EXPECT_EQ(symmetric_difference(transformed(p, 0x1p-400, none), transformed(q, 0x1p-400, none)),
              std::ldexp(area, -800));
}

} // namespace

} // namespace dsc::scenes::symmetric_difference_test
