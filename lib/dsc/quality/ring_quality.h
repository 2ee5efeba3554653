// SPDX-License-Identifier: MIT
// Quality of a vertex's star on all lanes at once. The measure is equation 4, 2/sqrt(3) sin(min
// angle), squared, so that no square root is taken: sin(min angle) = 2 area / (product of the two
// longest edges). Negative where a triangle is inverted.
#pragma once

#include "dsc/base/tolerances.h"
#include "dsc/complex/ring.h"

#include <cmath>
#include <limits>

namespace dsc {

/// The smallest signed squared quality of the ring's triangles with the centre at (px, py).
template <class Real>
Real worst_quality_squared(const Ring<Real>& ring, Real px, Real py) {
    Real worst = std::numeric_limits<Real>::max();
    const std::uint32_t n = ring.padded();
    const Real* x = ring.x.data();
    const Real* y = ring.y.data();
    const Real* x_next = ring.x_next.data();
    const Real* y_next = ring.y_next.data();
#pragma omp simd reduction(min : worst)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real ax = x[i] - px;
        const Real ay = y[i] - py;
        const Real bx = x_next[i] - px;
        const Real by = y_next[i] - py;
        const Real cx = bx - ax;
        const Real cy = by - ay;
        const Real area2 = ax * by - ay * bx;
        const Real aa = ax * ax + ay * ay;
        const Real bb = bx * bx + by * by;
        const Real cc = cx * cx + cy * cy;
        const Real shortest = std::min(aa, std::min(bb, cc));
        const Real sine_squared = (area2 * std::abs(area2)) * shortest / (aa * bb * cc);
        worst = std::min(worst, sine_squared);
    }
    return worst * Real(4.0 / 3.0);
}

/// The same after a collapse of the centre into link vertex i: its two triangles vanish, the others
/// take link vertex i for the centre. Only for closed rings of at least four triangles.
template <class Real>
Real worst_quality_squared_after_collapse(const Ring<Real>& ring, std::uint32_t i) {
    Real worst = std::numeric_limits<Real>::max();
    const std::uint32_t n = ring.size;
    const std::uint32_t before = i == 0 ? n - 1 : i - 1;
    const Real* x = ring.x.data();
    const Real* y = ring.y.data();
    const Real* x_next = ring.x_next.data();
    const Real* y_next = ring.y_next.data();
    const Real px = x[i];
    const Real py = y[i];
    constexpr Real harmless = std::numeric_limits<Real>::max();
#pragma omp simd reduction(min : worst)
    for (std::uint32_t j = 0; j < n; ++j) {
        const Real ax = x[j] - px;
        const Real ay = y[j] - py;
        const Real bx = x_next[j] - px;
        const Real by = y_next[j] - py;
        const Real cx = bx - ax;
        const Real cy = by - ay;
        const Real area2 = ax * by - ay * bx;
        const Real aa = ax * ax + ay * ay;
        const Real bb = bx * bx + by * by;
        const Real cc = cx * cx + cy * cy;
        const Real shortest = std::min(aa, std::min(bb, cc));
        const Real product = aa * bb * cc;
        const Real sine_squared =
            j == i || j == before ? harmless : (area2 * std::abs(area2)) * shortest / product;
        worst = std::min(worst, sine_squared);
    }
    return worst == harmless ? worst : worst * Real(4.0 / 3.0);
}

/// Squared lengths of the longest and the shortest spoke.
template <class Real>
struct SpokeLengths {
    Real longest;
    Real shortest;
};

template <class Real>
SpokeLengths<Real> spoke_lengths_squared(const Ring<Real>& ring) {
    Real longest = 0;
    Real shortest = std::numeric_limits<Real>::max();
    const std::uint32_t n = ring.padded();
    const Real* x = ring.x.data();
    const Real* y = ring.y.data();
    const Real px = ring.x0;
    const Real py = ring.y0;
#pragma omp simd reduction(max : longest) reduction(min : shortest)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real ax = x[i] - px;
        const Real ay = y[i] - py;
        const Real aa = ax * ax + ay * ay;
        longest = std::max(longest, aa);
        shortest = std::min(shortest, aa);
    }
    if (!ring.closed) {
        const Real ax = ring.link_x(ring.size) - px;
        const Real ay = ring.link_y(ring.size) - py;
        longest = std::max(longest, ax * ax + ay * ay);
        shortest = std::min(shortest, ax * ax + ay * ay);
    }
    return {longest, shortest};
}

/// True if every triangle with the centre at (px, py) is certainly positive; false sends the caller
/// to the exact predicate.
template <class Real>
bool certainly_positive(const Ring<Real>& ring, Real px, Real py) {
    Real least = std::numeric_limits<Real>::max();
    Real scale = std::numeric_limits<Real>::max();
    const std::uint32_t n = ring.padded();
    const Real* x = ring.x.data();
    const Real* y = ring.y.data();
    const Real* x_next = ring.x_next.data();
    const Real* y_next = ring.y_next.data();
#pragma omp simd reduction(min : least) reduction(min : scale)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real left = (x[i] - px) * (y_next[i] - py);
        const Real right = (y[i] - py) * (x_next[i] - px);
        const Real size = std::abs(left) + std::abs(right);
        least = std::min(least, (left - right) - area_bound<Real> * size);
        scale = std::min(scale, size);
    }
    // Below this, products may have lost bits to underflow.
    constexpr Real guard = std::numeric_limits<Real>::min() / std::numeric_limits<Real>::epsilon();
    return least > 0 && scale > guard;
}

/// True if a spoke of a closed or open ring fails the Delaunay test by more than the slack: the
/// angles opposite to it add up to more than pi. Constrained spokes are not told apart.
template <class Real>
bool has_non_delaunay_spoke(const Ring<Real>& ring) {
    alignas(64) std::array<Real, Ring<Real>::room> area;
    alignas(64) std::array<Real, Ring<Real>::room> dot_first;  // angle at link vertex i
    alignas(64) std::array<Real, Ring<Real>::room> dot_second; // angle at link vertex i + 1
    const std::uint32_t n = ring.padded();
    const Real* x = ring.x.data();
    const Real* y = ring.y.data();
    const Real* x_next = ring.x_next.data();
    const Real* y_next = ring.y_next.data();
    const Real px = ring.x0;
    const Real py = ring.y0;
    Real* areas = area.data() + 1;
    Real* firsts = dot_first.data() + 1;
    Real* seconds = dot_second.data() + 1;
#pragma omp simd
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real ax = x[i] - px;
        const Real ay = y[i] - py;
        const Real bx = x_next[i] - px;
        const Real by = y_next[i] - py;
        const Real cx = bx - ax;
        const Real cy = by - ay;
        areas[i] = ax * by - ay * bx;
        firsts[i] = -(ax * cx + ay * cy);
        seconds[i] = bx * cx + by * cy;
    }
    const std::uint32_t size = ring.size;
    const std::uint32_t begin = ring.closed ? 0 : 1;
    if (ring.closed) {
        area[0] = areas[size - 1];
        dot_first[0] = firsts[size - 1];
        dot_second[0] = seconds[size - 1];
    }
    Real worst = 0;
#pragma omp simd reduction(min : worst)
    for (std::uint32_t i = begin; i < size; ++i) {
        // Spoke i lies between triangle i - 1 (its far angle at vertex i - 1) and triangle i.
        const Real one = area[i + 1] * dot_first[i];
        const Real two = area[i] * dot_second[i + 1];
        worst = std::min(worst, one + two + delaunay_slack<Real> * (std::abs(one) + std::abs(two)));
    }
    return worst < 0;
}

} // namespace dsc
