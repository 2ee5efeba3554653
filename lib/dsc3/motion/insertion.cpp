// SPDX-License-Identifier: MIT
#include "dsc3/motion/insertion.h"

#include "dsc3/geometry/tet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace dsc3 {

namespace {

// The largest offset, in lengths of the edge; where a sheet ends, its normals tell less of it.
constexpr Real largest_offset = 0.2;
constexpr Real largest_at_end = 0.1;
// An edge goes on along another if the cosine of their angle is above this.
constexpr Real goes_on = 0.5;

Point limited(const Point& middle, const Point& offset, Real limit) {
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
                   largest_offset * (complex.at(b) - complex.at(a)).norm());
}

// The neighbour on the far side of the centre from the end of the edge, or null if none is.
const StarEdge* opposite(const Complex& complex, const InterfaceStar& star, const Point& edge) {
    const StarEdge* best = nullptr;
    Real most = goes_on * edge.norm();
    for (const StarEdge& one : star.edges) {
        const Point way = complex.at(one.vertex) - complex.at(star.centre);
        const Real along = way.dot(edge) / way.norm();
        if (along > most) {
            most = along;
            best = &one;
        }
    }
    return best;
}

// The share of its bend at the centre of the star that a sheet keeps along an edge, a vector to the
// centre, at the other end of which it ends. Where the next vertex in the opposite direction is
// bent less, the sheet is bent as the harmonic mean of both: not at all if it turns between them.
Real kept_bend(const Complex& complex, Workspace& work, const InterfaceStar& star,
               const Point& edge, Real rise, InterfaceStar& beyond) {
    const StarEdge* const next = opposite(complex, star, edge);
    if (next == nullptr) {
        return 1;
    }
    gather(complex, next->vertex, work.star);
    gather(complex, work.star, beyond);
    if (!is_sheet(beyond)) {
        return 1;
    }
    const Point way = complex.at(next->vertex) - complex.at(star.centre);
    const Real near = rise / edge.squaredNorm();
    const Real far = way.dot(normal(complex, beyond)) / way.squaredNorm();
    return near * far > 0 ? std::min(2 * far / (near + far), Real(1)) : 0;
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
    const bool is_between = at_a.is_closed && at_b.is_closed;
    if ((!at_a.is_closed && !at_b.is_closed) || (is_between && !(rise_a * rise_b > 0))) {
        return middle;
    }
    // Where the curvature changes along the edge, as at the rim of a film, the arithmetic mean of
    // the rises would be too large by a third.
    const Real sum = rise_a + rise_b;
    const Real share = is_between       ? 2 * rise_a * rise_b / (sum * sum)
                       : at_b.is_closed ? kept_bend(complex, work, star_b, edge, rise_b, star_a)
                                        : kept_bend(complex, work, star_a, -edge, rise_a, star_b);
    // The offset of a cubic, 1/8 instead of the factor, times that of a circle over that of a
    // cubic.
    const Real sine = share * sum / edge.norm();
    const Real cosine = std::sqrt(std::max(1 - sine * sine, Real(0.25)));
    const Real factor = 0.5 * share / (cosine * (1 + cosine));
    const Point offset = factor * (rise_b * at_b.normal + rise_a * at_a.normal);
    return limited(middle, offset, (is_between ? largest_offset : largest_at_end) * edge.norm());
}

} // namespace dsc3
