// SPDX-License-Identifier: MIT
// Checks of networks of curves: pieces, phases on both sides, areas and angles.
#pragma once

#include "dsc/geometry/triangle.h"
#include "dsc/queries/validate.h"
#include "support/initial_testing.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

namespace dsc::test {

struct CurveScenery {
    std::vector<Curve> curves;
    double edge_length = 0.05;
    Rectangle domain{};
};

template <class Real>
Complex<Real> complex_of(const CurveScenery& scenery) {
    return initial_complex<Real>(scenery.domain, scenery.curves,
                                 {.edge_length = scenery.edge_length});
}

template <class Real>
std::map<Phase, double> areas_by_phase(const Complex<Real>& complex) {
    std::map<Phase, long double> sums;
    for (const Triangle t : triangles(complex)) {
        const auto [a, b, c] = complex.vertices_of(t);
        const auto at = [&](Vertex v) -> Point<double> {
            return complex.position(v).template cast<double>();
        };
        sums[complex.phase(t)] += area<double>(at(a), at(b), at(c));
    }
    return {sums.begin(), sums.end()};
}

/// The smallest angle of all triangles, in degrees.
template <class Real>
double smallest_angle(const Complex<Real>& complex) {
    double smallest = 60;
    for (const Triangle t : triangles(complex)) {
        const auto [a, b, c] = complex.vertices_of(t);
        const auto at = [&](Vertex v) -> Point<double> {
            return complex.position(v).template cast<double>();
        };
        smallest = std::min(smallest, min_angle_deg<double>(at(a), at(b), at(c)));
    }
    return smallest;
}

/// Checks that each curve is divided at the promised points and has its phases on both sides, and
/// that there is no other interface.
template <class Real>
void expect_curves(const Complex<Real>& complex, const CurveScenery& scenery) {
    const auto found = vertices_by_position(complex);
    const auto id_of = [&](const Point<double>& p) {
        const auto at = found.find({static_cast<Real>(p.x()), static_cast<Real>(p.y())});
        return at == found.end() ? no_id : at->second;
    };
    std::size_t pieces = 0;
    std::size_t lost = 0;
    std::size_t wrong = 0;
    for (const Curve& curve : scenery.curves) {
        for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
            const auto rounded = [](const Point<double>& p) -> Point<double> {
                return p.template cast<Real>().template cast<double>();
            };
            const double length = (curve.points[i + 1] - curve.points[i]).norm();
            const int n = static_cast<int>(
                std::max(1.0, std::ceil(length / scenery.edge_length * (1 - 1e-9))));
            const Point<double> a = rounded(curve.points[i]);
            const Point<double> b = rounded(curve.points[i + 1]);
            for (int k = 0; k < n; ++k, ++pieces) {
                const auto point = [&](int j) -> Point<double> {
                    return j == 0 ? a : (j == n ? b : rounded(a + (double(j) / n) * (b - a)));
                };
                const Vertex from{id_of(point(k))};
                const Vertex to{id_of(point(k + 1))};
                const Corner left =
                    from.is_valid() && to.is_valid() ? complex.find_half_edge(from, to) : no_id;
                if (left == no_id) {
                    ++lost;
                } else {
                    wrong += complex.phase_at(left) != curve.left ||
                             complex.phase_at(complex.twin(left)) != curve.right;
                }
            }
        }
    }
    EXPECT_EQ(lost, 0U) << "pieces of the curves are no edges";
    EXPECT_EQ(wrong, 0U) << "pieces have other phases at their sides";
    EXPECT_EQ(interface_edge_count(complex), pieces) << "edges of the interface";
}

/// Checks that the complex is valid and constrained Delaunay, has no edges longer than this
/// multiple of the target, and no temporary data of its construction.
template <class Real>
void expect_sound(const Complex<Real>& complex, const CurveScenery& scenery, double longest = 1.8) {
    const auto report = validate(complex);
    ASSERT_TRUE(report.ok()) << report.problem;
    EXPECT_EQ(report.components, 1U);
    EXPECT_EQ(report.boundary_loops, 1U);
    EXPECT_EQ(report.unused_vertices, 0U);
    const Sizes sizes = sizes_of(complex);
    const double whole = (scenery.domain.high - scenery.domain.low).prod();
    EXPECT_NEAR(sizes.area, whole, (std::is_same_v<Real, double> ? 1e-12 : 1e-6) * whole);
    EXPECT_EQ(sizes.not_delaunay, 0U);
    EXPECT_LE(sizes.longest, longest * scenery.edge_length);
    EXPECT_TRUE(std::all_of(complex.triangles.begin() + 1, complex.triangles.end(),
                            [](const TriangleRecord& t) { return t.mark == 0; }));
    EXPECT_TRUE(std::all_of(complex.vertices.begin(), complex.vertices.end(),
                            [](const VertexRecord<Real>& v) {
                                return v.flags == 0 && v.stamp == 0 && v.slot == no_id;
                            }));
    expect_curves(complex, scenery);
}

} // namespace dsc::test
