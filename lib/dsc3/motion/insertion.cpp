// SPDX-License-Identifier: MIT
#include "dsc3/motion/insertion.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace dsc3 {

namespace {

// An offset of at most a fifth of the edge.
Point limited(const Point& middle, const Point& offset, const Point& edge) {
    const Real limit = 0.2 * edge.norm();
    const Real length = offset.norm();
    return middle + (length > limit ? Point((limit / length) * offset) : offset);
}

// The vertex before the end of an edge on a curve, or no_id if the curve ends there.
std::uint32_t before(InterfaceStar& end, std::uint32_t other) {
    if (classify(end) != Stratum::curve) {
        return no_id;
    }
    const auto edge = std::find_if(end.edges.begin(), end.edges.end(), [&](const StarEdge& one) {
        return one.is_on_curve() && one.vertex != other;
    });
    return edge->vertex;
}

// The value half-way between parameters t[1] and t[2] of the polynomial through the points.
Point interpolate(std::span<const Point> points, std::span<const Real> t, Real at) {
    Point sum = Point::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        Real weight = 1;
        for (std::size_t j = 0; j < points.size(); ++j) {
            weight *= j == i ? 1 : (at - t[j]) / (t[i] - t[j]);
        }
        sum += weight * points[i];
    }
    return sum;
}

// On the polynomial through the ends of the edge and the next vertices of the curve, by chord
// length.
Point middle_of_curve(const Complex& complex, std::uint32_t before_a, std::uint32_t a,
                      std::uint32_t b, std::uint32_t after_b) {
    std::array<Point, 4> points;
    std::array<Real, 4> t{};
    std::size_t n = 0;
    Real at = 0;
    for (const std::uint32_t v : {before_a, a, b, after_b}) {
        if (v == no_id) {
            continue;
        }
        points[n] = complex.at(v);
        t[n] = n == 0 ? 0 : t[n - 1] + (points[n] - points[n - 1]).norm();
        at += v == a || v == b ? 0.5 * t[n] : 0;
        ++n;
    }
    const Point middle = midpoint(complex.at(a), complex.at(b));
    return limited(middle, interpolate({points.data(), n}, {t.data(), n}, at) - middle,
                   complex.at(b) - complex.at(a));
}

} // namespace

Point curved_middle(const Complex& complex, Workspace& work, std::uint32_t a, std::uint32_t b) {
    InterfaceStar& star_a = work.interface_star;
    InterfaceStar& star_b = work.other_interface_star;
    gather(complex, a, work.star);
    gather(complex, work.star, star_a);
    gather(complex, b, work.star);
    gather(complex, work.star, star_b);
    const std::uint32_t before_a = before(star_a, b);
    const std::uint32_t after_b = before(star_b, a);
    const StarEdge* const edge_a = star_a.edge_to(b);
    const StarEdge* const edge_b = star_b.edge_to(a);
    const Point middle = midpoint(complex.at(a), complex.at(b));
    if (edge_a == nullptr || edge_b == nullptr) {
        return middle;
    }
    if (edge_a->is_on_curve()) {
        return middle_of_curve(complex, before_a, a, b, after_b);
    }
    const SheetNormal at_a = normal_at(complex, star_a, *edge_a);
    const SheetNormal at_b = normal_at(complex, star_b, *edge_b);
    if (at_a.normal.dot(at_b.normal) < 0) {
        return middle;
    }
    // Beside a curve, where a sheet ends, its normal is less accurate: only the other one counts.
    const Point edge = complex.at(b) - complex.at(a);
    const Real rise_a = at_a.is_closed ? -edge.dot(at_a.normal) : 0;
    const Real rise_b = at_b.is_closed ? edge.dot(at_b.normal) : 0;
    if (!at_a.is_closed && !at_b.is_closed) {
        return middle;
    }
    // Where the curvature changes along the edge, as at the rim of a film, the arithmetic mean of
    // the rises would be too large by a third.
    const bool is_between = at_a.is_closed && at_b.is_closed;
    if (is_between && !(rise_a * rise_b > 0)) {
        return middle;
    }
    const Real sum = rise_a + rise_b;
    const Real share = is_between ? 2 * rise_a * rise_b / (sum * sum) : 1;
    // The offset of a cubic, 1/8 instead of the factor, times that of a circle over that of a
    // cubic.
    const Real sine = share * sum / edge.norm();
    const Real cosine = std::sqrt(std::max(1 - sine * sine, Real(0.25)));
    const Real factor = 0.5 * share / (cosine * (1 + cosine));
    const Point offset = factor * (rise_b * at_b.normal + rise_a * at_a.normal);
    return limited(middle, offset, edge);
}

} // namespace dsc3
