// SPDX-License-Identifier: MIT
// Domains of any shape for fluids.
#pragma once

#include "fluid/scenes.h"

#include <numbers>
#include <string>
#include <vector>

namespace dsc::fluid_domains {

using std::numbers::pi;
using Points = std::vector<Point<double>>;

inline Points circle(double radius, int n) {
    Points points;
    for (int i = 0; i < n; ++i) {
        points.emplace_back(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n));
    }
    return points;
}

inline constexpr double slope = 0.3; // rotation of the domains, in radians
inline Point<double> turned(double x, double y) {
    return {std::cos(slope) * x - std::sin(slope) * y, std::sin(slope) * x + std::cos(slope) * y};
}
inline Point<double> turned_back(const Point<double>& p) {
    return {std::cos(slope) * p.x() + std::sin(slope) * p.y(),
            -std::sin(slope) * p.x() + std::cos(slope) * p.y()};
}
inline Polygon turned_rectangle(double length) {
    return {{turned(0, 0), turned(length, 0), turned(length, 1), turned(0, 1)}};
}

inline Polygon channel_with_cylinder() {
    Points hole = circle(0.25, 24);
    for (Point<double>& p : hole) {
        p += Point<double>(0.7, 0.5);
    }
    return {{{0, 0}, {3, 0}, {3, 1}, {0, 1}}, {hole}};
}

inline Complex<double> mesh_of(const Polygon& domain, double h,
                               const std::vector<Shape>& shapes = {}) {
    return initial_complex<double>(domain, shapes, {.edge_length = h});
}

inline FluidOptions one_fluid() {
    FluidOptions options;
    options.phases = {{.phase = 0}};
    return options;
}

/// Names for the edges of the outline, from the first one on.
inline std::vector<DomainEdge> edges_of(const Polygon& domain,
                                        const std::vector<std::string>& names) {
    std::vector<DomainEdge> edges;
    for (std::size_t i = 0; i < names.size(); ++i) {
        edges.push_back(
            {domain.outline[i], domain.outline[(i + 1) % domain.outline.size()], names[i]});
    }
    return edges;
}

} // namespace dsc::fluid_domains
