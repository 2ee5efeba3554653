// SPDX-License-Identifier: MIT
// Quality measures (thesis, section 4.3): of the simplices of a complex, and of a vertex's star on
// all lanes at once. geometry/triangle.h defines them for points, with their ranges. Stars use the
// square of equation 4, which needs no square root, with a negative sign for inverted triangles.
#pragma once

#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"
#include "dsc/geometry/points.h"
#include "dsc/geometry/predicates.h"
#include "dsc/geometry/triangle.h"

#include <cmath>
#include <limits>

namespace dsc {

/// Equation 2: the length of an edge.
template <class Real>
[[nodiscard]] Real length(const Complex<Real>& complex, Edge e) {
    const auto [a, b] = complex.vertices_of(e);
    return distance(complex.position(a), complex.position(b));
}
/// Equation 3: the signed area of a triangle.
template <class Real>
[[nodiscard]] Real area(const Complex<Real>& complex, Triangle t) {
    const auto [a, b, c] = complex.positions_of(t);
    return area<Real>(a, b, c);
}
/// Equation 4: the quality of a triangle.
template <class Real>
[[nodiscard]] Real quality(const Complex<Real>& complex, Triangle t) {
    const auto [a, b, c] = complex.positions_of(t);
    return quality<Real>(a, b, c);
}
/// The smallest angle, in degrees, 0 to 60.
template <class Real>
[[nodiscard]] Real min_angle_deg(const Complex<Real>& complex, Triangle t) {
    const auto [a, b, c] = complex.positions_of(t);
    return min_angle_deg<Real>(a, b, c);
}

/// Whether the edge opposite to `corner`, which must have two triangles, is Delaunay.
template <class Real>
bool is_delaunay(const Complex<Real>& complex, Corner corner) {
    return is_delaunay<Real>(complex.position(Vertex{complex.vertex(corner)}),
                             complex.position(Vertex{complex.vertex(next(corner))}),
                             complex.position(Vertex{complex.vertex(complex.twin(corner))}),
                             complex.position(Vertex{complex.vertex(prev(corner))}));
}

// --- of a star -----------------------------------------------------------------------------------

/// The signed squared quality of a triangle, as that of a star.
template <class Real>
Real quality_squared(const Point<Real>& a, const Point<Real>& b, const Point<Real>& c) {
    return sine_squared_of_lanes<Real>(b.x() - a.x(), b.y() - a.y(), c.x() - a.x(), c.y() - a.y()) *
           Real(4.0 / 3.0);
}

/// The smallest signed squared quality of the star's triangles with the centre at (px, py).
template <class Real>
Real worst_quality_squared(const Star<Real>& star, Real px, Real py) {
    Real worst = std::numeric_limits<Real>::max();
    const std::uint32_t n = star.padded();
#pragma omp simd reduction(min : worst)
    for (std::uint32_t i = 0; i < n; ++i) {
        worst =
            std::min(worst, sine_squared_of_lanes<Real>(star.x[i] - px, star.y[i] - py,
                                                        star.x_next[i] - px, star.y_next[i] - py));
    }
    return worst * Real(4.0 / 3.0);
}

/// The smallest squared quality after a collapse of the centre into link vertex i: its two
/// triangles vanish, the others take link vertex i for the centre. Only for closed stars of at
/// least four triangles.
template <class Real>
Real worst_quality_squared_after_collapse(const Star<Real>& star, std::uint32_t i) {
    const std::uint32_t n = star.size;
    const std::uint32_t lanes = star.padded();
    const Real px = star.x[i];
    const Real py = star.y[i];
    alignas(64) std::array<Real, Star<Real>::room> sine_squared;
#pragma omp simd
    for (std::uint32_t j = 0; j < lanes; ++j) {
        sine_squared[j] = sine_squared_of_lanes<Real>(star.x[j] - px, star.y[j] - py,
                                                      star.x_next[j] - px, star.y_next[j] - py);
    }
    constexpr Real harmless = std::numeric_limits<Real>::max();
    sine_squared[i] = harmless;
    sine_squared[i == 0 ? n - 1 : i - 1] = harmless;
    Real worst = harmless;
    for (std::uint32_t j = 0; j < n; ++j) {
        worst = std::min(worst, sine_squared[j]);
    }
    return worst == harmless ? worst : worst * Real(4.0 / 3.0);
}

/// True if every triangle with the centre at (px, py) is certainly positive; if false, the exact
/// predicate has to decide.
template <class Real>
bool certainly_positive(const Star<Real>& star, Real px, Real py) {
    Real smallest = std::numeric_limits<Real>::max();
    Real scale = std::numeric_limits<Real>::max();
    const std::uint32_t n = star.padded();
#pragma omp simd reduction(min : smallest) reduction(min : scale)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real left = (star.x[i] - px) * (star.y_next[i] - py);
        const Real right = (star.y[i] - py) * (star.x_next[i] - px);
        const Real size = std::abs(left) + std::abs(right);
        smallest = std::min(smallest, (left - right) - area_bound<Real> * size);
        scale = std::min(scale, size);
    }
    // Below this, products may have lost bits to underflow.
    constexpr Real guard = std::numeric_limits<Real>::min() / std::numeric_limits<Real>::epsilon();
    // A minimum ignores NaN, so the last two comparisons must refuse a centre that is NaN, or so
    // far away that products overflow and their difference is NaN.
    constexpr Real far = sizeof(Real) == sizeof(double) ? Real(1e150) : Real(1e18);
    return smallest > 0 && scale > guard && std::abs(px) < far && std::abs(py) < far;
}

/// True if every star triangle is strictly positive with the centre at (px, py); exact.
template <class Real>
bool all_positive(const Star<Real>& star, Real px, Real py) {
    if (certainly_positive(star, px, py)) {
        return true;
    }
    for (std::uint32_t i = 0; i < star.size; ++i) {
        if (orientation(static_cast<double>(px), static_cast<double>(py),
                        static_cast<double>(star.x[i]), static_cast<double>(star.y[i]),
                        static_cast<double>(star.x_next[i]),
                        static_cast<double>(star.y_next[i])) <= 0) {
            return false;
        }
    }
    return true;
}

/// The figures of a star that a mesh update needs, computed in one loop.
template <class Real>
struct StarReport {
    Real delaunay; ///< below 0: an incident edge fails the Delaunay test by more than the slack
    Real longest;  ///< squared length of the longest incident edge
    Real shortest; ///< squared length of the shortest incident edge
    Real quality;  ///< as `worst_quality_squared`
};

/// The Delaunay margin of an incident edge, from its end and the previous and the next link vertex,
/// relative to the centre: the angles opposite to the edge lie at these two vertices.
template <class Real>
[[nodiscard]] Real incident_edge_margin(Real x, Real y, Real x_next, Real y_next, Real x_previous,
                                        Real y_previous) {
    return delaunay_margin<Real>(x * y_next - y * x_next,
                                 x_next * (x_next - x) + y_next * (y_next - y),
                                 x_previous * y - y_previous * x,
                                 -(x_previous * (x - x_previous) + y_previous * (y - y_previous)));
}

/// The Delaunay margin of each incident edge of a star, as `delaunay_margin`: below 0 where an
/// incident edge fails the test by more than the slack. Incident edge 0 of an open star never
/// fails.
template <class Real>
using IncidentEdgeMargins = std::array<Real, Star<Real>::room>;

/// Examines the star: Delaunay test of the incident edges (the angles opposite to one add up to at
/// most pi; constrained incident edges are treated like others), their lengths, the worst quality.
/// Also writes the margin of each incident edge. O(degree).
template <class Real>
StarReport<Real> examine(const Star<Real>& star, IncidentEdgeMargins<Real>& margins) {
    constexpr Real largest = std::numeric_limits<Real>::max();
    Real delaunay = 0;
    Real longest = 0;
    Real shortest = largest;
    Real worst = largest;
    const std::uint32_t n = star.padded();
    const Real px = star.x0;
    const Real py = star.y0;
#pragma omp simd reduction(min : delaunay, shortest, worst) reduction(max : longest)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real ax = star.x[i] - px;
        const Real ay = star.y[i] - py;
        const Real bx = star.x_next[i] - px;
        const Real by = star.y_next[i] - py;
        const Real ex = star.x_previous[i] - px;
        const Real ey = star.y_previous[i] - py;
        const Real found = incident_edge_margin<Real>(ax, ay, bx, by, ex, ey);
        margins[i] = found;
        delaunay = std::min(delaunay, found);
        const Real aa = ax * ax + ay * ay;
        longest = std::max(longest, aa);
        shortest = std::min(shortest, aa);
        worst = std::min(worst, sine_squared_of_lanes<Real>(ax, ay, bx, by));
    }
    if (!star.closed) {
        const Real last = star.squared_edge(star.size);
        longest = std::max(longest, last);
        shortest = std::min(shortest, last);
    }
    return {delaunay, longest, shortest, worst * Real(4.0 / 3.0)};
}

/// The same without the margins.
template <class Real>
StarReport<Real> examine(const Star<Real>& star) {
    IncidentEdgeMargins<Real> margins;
    return examine(star, margins);
}

} // namespace dsc
