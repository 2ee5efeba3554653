// SPDX-License-Identifier: MIT
// Small complexes for the tests of the reference, the thesis's method taken literally: checkable by
// hand.
#pragma once

#include "dsc/base/types.h"
#include "reference/algorithm/quality.h"
#include "reference/complex/validate.h"

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

inline void expect_valid(const Complex& K) {
    for (const std::string& fault : validate(K))
        ADD_FAILURE() << fault;
}

/// The unit square in 20 x 20 cells, of which those from `low` up to `high` in both directions have
/// phase 1.
inline Complex square_in_square(std::size_t low, std::size_t high) {
    std::vector<std::size_t> inside;
    for (std::size_t j = low; j < high; ++j) {
        for (std::size_t i = low; i < high; ++i)
            inside.insert(inside.end(), {2 * (20 * j + i), 2 * (20 * j + i) + 1});
    }
    Complex K = grid(20, inside);
    for (Vertex v : K.vertices())
        K.set_coord(v, K.coord(v) / 20);
    return K;
}

} // namespace dsc::reference
