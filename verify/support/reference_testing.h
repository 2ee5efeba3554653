// SPDX-License-Identifier: MIT
// Small complexes for the tests of the reference, the thesis's method taken literally: checkable by
// hand, and a square with a circle.
#pragma once

#include "dsc/base/types.h"
#include "reference/algorithm/movement.h"
#include "reference/algorithm/quality.h"
#include "reference/complex/validate.h"
#include "reference/operations/edge_split.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace dsc::reference {

using Points = std::vector<Point<double>>;
using Triples = std::vector<std::array<std::uint32_t, 3>>;

inline Vertex operator""_v(unsigned long long id) { return Vertex{static_cast<std::uint32_t>(id)}; }

inline EdgeKey E(std::uint32_t a, std::uint32_t b) { return edge_key(Vertex{a}, Vertex{b}); }
inline TriangleKey T(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return triangle_key(Vertex{a}, Vertex{b}, Vertex{c});
}

/// All triangles of phase 0, except those listed in `inside`, which have phase 1.
inline Complex make(const Points& points, const Triples& triangles,
                    const std::vector<std::size_t>& inside = {}) {
    std::vector<Phase> phases(triangles.size(), exterior_phase);
    for (std::size_t i : inside)
        phases[i] = 1;
    return make_complex(points, triangles, phases);
}

/// The unit square 0 1 2 3 (counter-clockwise from the origin) with the diagonal 0 2.
inline Complex square(const std::vector<std::size_t>& inside = {}) {
    return make({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}, inside);
}

/// Vertex 0 at the origin and 1 to 6 on the unit circle, counter-clockwise from angle 0.
inline Complex fan(const std::vector<std::size_t>& inside = {}) {
    const double s = std::sqrt(0.75);
    return make({{0, 0}, {1, 0}, {.5, s}, {-.5, s}, {-1, 0}, {-.5, -s}, {.5, -s}},
                {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}}, inside);
}

/// n x n unit squares; vertex (i, j) is j (n + 1) + i; diagonals from lower left to upper right.
/// Triangles 2 (j n + i) below the diagonal and the next above.
inline Complex grid(std::uint32_t n, const std::vector<std::size_t>& inside = {}) {
    Points points;
    Triples triangles;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i)
            points.emplace_back(i, j);
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            triangles.push_back({a, a + 1, a + n + 2});
            triangles.push_back({a, a + n + 2, a + n + 1});
        }
    }
    return make(points, triangles, inside);
}

inline double total_area(const Complex& K, Phase phase) {
    double sum = 0;
    for (const auto& [t, p] : K.phases())
        sum += p == phase ? area(K, t) : 0.0;
    return sum;
}

inline double worst_quality(const Complex& K) {
    double worst = 1;
    for (const auto& item : K.phases())
        worst = std::min(worst, quality(K, item.first));
    return worst;
}

inline void expect_valid(const Complex& K) {
    for (const std::string& fault : validate(K))
        ADD_FAILURE() << fault;
}

/// The unit square in n x n cells with a circle of phase 1: vertices near the circle are moved onto
/// it, and edges that still cross it are split there.
inline Complex circle_in_square(std::uint32_t n, const Point<double>& centre, double radius) {
    Complex K = grid(n);
    for (Vertex v : K.vertices())
        K.set_coord(v, K.coord(v) / n);
    const auto height = [&](const Point<double>& p) { return (p - centre).norm() - radius; };
    std::set<Vertex> on;
    for (Vertex v : K.vertices()) {
        const Point<double> p = K.coord(v);
        if (std::abs(height(p)) < 0.35 / n && !K.is_boundary(v) &&
            move_vertex(v, centre + radius * (p - centre).normalized(), K)) {
            on.insert(v);
        }
    }
    const auto side = [&](Vertex v) { return on.contains(v) ? 0.0 : height(K.coord(v)); };
    std::vector<EdgeKey> crossing;
    for (const auto& item : K.edges()) {
        if (side(item.first.v[0]) * side(item.first.v[1]) < 0)
            crossing.push_back(item.first);
    }
    for (const EdgeKey& e : crossing) {
        Point<double> a = K.coord(e.v[0]);
        Point<double> b = K.coord(e.v[1]);
        for (int i = 0; i < 60; ++i) {
            const Point<double> m = 0.5 * (a + b);
            (height(m) * side(e.v[0]) > 0 ? a : b) = m;
        }
        EXPECT_EQ(edge_split(e, K, a), Verdict::legal);
        on.insert(*K.vertices().rbegin());
    }
    for (const auto& item : K.triangles()) {
        double extreme = 0;
        for (Vertex v : item.first.v) {
            if (std::abs(side(v)) > std::abs(extreme))
                extreme = side(v);
        }
        K.set_phase(item.first, extreme < 0 ? 1 : 0);
    }
    return K;
}

} // namespace dsc::reference
