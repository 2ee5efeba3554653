// SPDX-License-Identifier: MIT
// Small complexes for the tests: wheels, and grids whose inner vertices are jittered.
#pragma once

#include "dsc/complex/complex.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace dsc::test {

using Indices = std::array<std::uint32_t, 3>;

template <class Real>
Complex<Real> build(const std::vector<Point<Real>>& points, const std::vector<Indices>& triangles,
                    const std::vector<Phase>& phases) {
    return make_complex<Real>(std::span<const Point<Real>>(points),
                              std::span<const Indices>(triangles), std::span<const Phase>(phases));
}

/// A wheel: vertex 0 in the middle, 1 to n around it counter-clockwise on the unit circle; triangle
/// i is (0, i, i + 1).
template <class Real>
Complex<Real> wheel(std::uint32_t n) {
    std::vector<Point<Real>> points{{0, 0}};
    std::vector<Indices> triangles;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        points.emplace_back(static_cast<Real>(std::cos(angle)), static_cast<Real>(std::sin(angle)));
        triangles.push_back({0, i + 1, (i + 1) % n + 1});
    }
    return build<Real>(points, triangles, std::vector<Phase>(n, 0));
}

template <class Real>
Complex<Real> hexagon() {
    return wheel<Real>(6);
}

/// n x n squares of side 1, each cut in two; vertex (i, j) has the id j (n + 1) + i. Inner vertices
/// are moved by up to `jitter` in both directions (below 0.2 no triangle is inverted). Triangles
/// whose centre is nearer than `radius` to the middle have phase 1, the others phase 0.
template <class Real>
Complex<Real> grid(std::uint32_t n, double jitter = 0, unsigned seed = 1, double radius = 0) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> move(-jitter, jitter);
    std::vector<Point<Real>> points;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i) {
            const bool inner = i > 0 && j > 0 && i < n && j < n;
            const double x = i + (inner ? move(random) : 0);
            const double y = j + (inner ? move(random) : 0);
            points.emplace_back(static_cast<Real>(x), static_cast<Real>(y));
        }
    }
    std::vector<Indices> triangles;
    std::vector<Phase> phases;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        triangles.push_back({a, b, c});
        const Point<Real> middle = (points[a] + points[b] + points[c]) / Real(3);
        const double away = std::hypot(static_cast<double>(middle.x()) - n / 2.0,
                                       static_cast<double>(middle.y()) - n / 2.0);
        phases.push_back(away < radius ? 1 : 0);
    };
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            const std::uint32_t b = a + 1;
            const std::uint32_t c = a + n + 1;
            const std::uint32_t d = c + 1;
            if ((random() & 1U) != 0) {
                add(a, b, d);
                add(a, d, c);
            } else {
                add(a, b, c);
                add(b, d, c);
            }
        }
    }
    return build<Real>(points, triangles, phases);
}

} // namespace dsc::test
