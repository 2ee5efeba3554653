// SPDX-License-Identifier: MIT
// Checks of the initial complex: positions of vertices, sizes, phases.
#pragma once

#include "dsc/complex/ranges.h"
#include "dsc/geometry/triangle.h"
#include "dsc/initial/initial_complex.h"
#include "dsc/quality/measures.h"
#include "shapes/outline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace dsc::test {

struct Scenery {
    Rectangle domain{};
    std::vector<Shape> shapes;
    double edge_length = 0.05;
};

/// The vertex at each point; two vertices never have the same position.
template <class Real>
std::map<std::pair<Real, Real>, std::uint32_t> vertices_by_position(const Complex<Real>& complex) {
    std::map<std::pair<Real, Real>, std::uint32_t> result;
    for (const Vertex v : vertices(complex)) {
        result[{complex.vertices[v.id].x, complex.vertices[v.id].y}] = v.id;
    }
    return result;
}

template <class Real>
std::size_t interface_edge_count(const Complex<Real>& complex) {
    std::size_t count = 0;
    for (const Triangle t : triangles(complex)) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Corner other = complex.twin(corner_of(t.id, i));
            count += !is_border(other) && complex.phase(t) < complex.phase_at(other);
        }
    }
    return count;
}

/// The sine of the sum of the angles opposite to the edge is not below the slack. Unlike the test
/// for flips, this one is relative to the lengths, so rectangles pass it.
template <class Real>
bool is_locally_delaunay(const Complex<Real>& complex, Corner corner) {
    // Scalars are used here and below, because under the sanitizers, without optimisation, Eigen's
    // vectors take longer than the tested code.
    struct Place {
        double x, y;
    };
    const auto at = [&](Corner c) -> Place {
        const auto& record = complex.vertices[complex.vertex(c)];
        return {static_cast<double>(record.x), static_cast<double>(record.y)};
    };
    const Place b = at(next(corner));
    const Place w = at(prev(corner));
    const auto sine_cosine = [&](const Place& apex) -> Place {
        const Place p{b.x - apex.x, b.y - apex.y};
        const Place q{w.x - apex.x, w.y - apex.y};
        const double lengths = std::sqrt(p.x * p.x + p.y * p.y) * std::sqrt(q.x * q.x + q.y * q.y);
        return {std::abs(p.x * q.y - p.y * q.x) / lengths, (p.x * q.x + p.y * q.y) / lengths};
    };
    const Place one = sine_cosine(at(corner));
    const Place other = sine_cosine(at(complex.twin(corner)));
    return one.x * other.y + one.y * other.x >= -static_cast<double>(delaunay_slack<Real>);
}

struct Sizes {
    double worst_quality = 2;
    double median_quality = 0;
    double shortest = 1e300;
    double longest = 0;
    double area = 0;
    std::size_t not_delaunay = 0;
};

template <class Real>
Sizes sizes_of(const Complex<Real>& complex) {
    Sizes sizes;
    std::vector<double> qualities;
    for (const Triangle t : triangles(complex)) {
        std::array<Point<double>, 3> p;
        for (std::uint32_t i = 0; i < 3; ++i) {
            p[i] = complex.position(Vertex{complex.triangles[t.id].v[i]}).template cast<double>();
        }
        qualities.push_back(quality<double>(p[0], p[1], p[2]));
        sizes.area += area<double>(p[0], p[1], p[2]);
        for (std::uint32_t i = 0; i < 3; ++i) {
            const double length = (p[(i + 1) % 3] - p[(i + 2) % 3]).norm();
            sizes.shortest = std::min(sizes.shortest, length);
            sizes.longest = std::max(sizes.longest, length);
            const Corner c = corner_of(t.id, i);
            if (complex.phase_at(c) == complex.phase_at(complex.twin(c))) {
                sizes.not_delaunay += is_locally_delaunay(complex, c) ? 0U : 1U;
            }
        }
    }
    std::sort(qualities.begin(), qualities.end());
    sizes.worst_quality = qualities.front();
    sizes.median_quality = qualities[qualities.size() / 2];
    return sizes;
}

/// Even-odd rule, in plain doubles: for points that are not near the outline.
inline bool is_inside(const std::vector<Point<double>>& outline, const Point<double>& p) {
    const double x = p.x();
    const double y = p.y();
    bool inside = false;
    const double* a = outline.back().data();
    for (const Point<double>& point : outline) {
        const double* b = point.data();
        if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) {
            inside = !inside;
        }
        a = b;
    }
    return inside;
}

/// The phase of the smallest shape around a point.
inline Phase innermost_phase(const std::vector<Shape>& shapes, const Point<double>& p) {
    const auto size_of = [](const Shape& shape) {
        return std::abs(scenes::signed_area(shape.outline));
    };
    const Shape* innermost = nullptr;
    for (const Shape& shape : shapes) {
        if (is_inside(shape.outline, p) &&
            (innermost == nullptr || size_of(shape) < size_of(*innermost))) {
            innermost = &shape;
        }
    }
    return innermost != nullptr ? innermost->phase : exterior_phase;
}

} // namespace dsc::test
