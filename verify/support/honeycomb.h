// SPDX-License-Identifier: MIT
// A mesh that needs no edits.
#pragma once

#include "dsc/complex/complex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace dsc::test {

/// Equilateral triangles of side 1 and phase 1, which fill a hexagon about the vertex 0 at the
/// origin.
inline Complex<double> honeycomb() {
    constexpr int rings = 6;
    std::vector<Point<double>> points;
    std::map<std::pair<int, int>, std::uint32_t> at;
    const auto add = [&](int i, int j) {
        at[{i, j}] = static_cast<std::uint32_t>(points.size());
        points.emplace_back(i + 0.5 * j, std::sqrt(3.0) / 2 * j);
    };
    add(0, 0);
    for (int i = -rings; i <= rings; ++i) {
        for (int j = std::max(-rings, -rings - i); j <= std::min(rings, rings - i); ++j) {
            if (i != 0 || j != 0) {
                add(i, j);
            }
        }
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto& [place, v] : at) {
        const auto [i, j] = place;
        for (const auto& [a, b] : {std::pair{std::pair{i + 1, j}, std::pair{i, j + 1}},
                                   std::pair{std::pair{i, j + 1}, std::pair{i - 1, j + 1}}}) {
            if (at.contains(a) && at.contains(b)) {
                triangles.push_back({v, at[a], at[b]});
            }
        }
    }
    const std::vector<Phase> phases(triangles.size(), 1);
    return make_complex<double>(points, triangles, phases);
}

} // namespace dsc::test
