// SPDX-License-Identifier: MIT
// The target length at a vertex, given its star. A value that grows with the distance propagates to
// a vertex along edges or across the triangles of its star, which is exact for a straight front (R.
// Kimmel, J. A. Sethian, "Computing geodesic paths on manifolds", 1998).
#pragma once

#include "dsc/base/error.h"
#include "dsc/complex/gather.h"
#include "dsc/sizes/sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc {

/// The minimum of value(q) + slope |p - q| over the points q strictly between a and b, where the
/// value is linear; infinity if the minimum is at an end, or if the values at both ends are
/// infinite. (ax, ay) and (bx, by) lead from p to a and b. `slope` must be positive. Branch-free.
template <class Real>
Real min_between(Real ax, Real ay, Real value_a, Real bx, Real by, Real value_b, Real slope) {
    const Real ex = bx - ax;
    const Real ey = by - ay;
    const Real squared = ex * ex + ey * ey;
    const Real along = -(ax * ex + ay * ey);
    const Real across = std::abs(ax * by - ay * bx);
    // While the front moves by the length of the edge, it moves by `rise` along the edge and by
    // `sideways` across it: 0 if the value is steeper than the slope, so that the minimum is at the
    // lower end.
    const Real rise = (value_b - value_a) / slope;
    const Real sideways = std::sqrt(std::max(Real(0), squared - rise * rise));
    const Real foot = along * sideways - across * rise; // over sideways: along the edge
    const Real value = value_a + slope * (rise * along + sideways * across) / squared;
    // Selects between constants, because a selection between computed values would become a branch,
    // and the loop over lanes would not be vectorised.
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const Real bound = std::min(foot, squared * sideways - foot) > 0 ? -infinity : infinity;
    return std::max(bound, value);
}

/// The values at the link of a star, padded like the star's coordinates, with those of the next
/// link vertex beside them.
template <class Real>
struct LinkValues {
    alignas(64) std::array<Real, Star<Real>::room> at;   ///< of link vertex i
    alignas(64) std::array<Real, Star<Real>::room> next; ///< of link vertex i + 1

    /// Stores value(v) for each vertex v of the link. O(degree).
    template <class Value>
    void take(const Star<Real>& star, Value value) {
        const std::uint32_t n = star.size;
        at[0] = value(star.link[0]);
        for (std::uint32_t i = 1; i <= n; ++i) { // the last one of an open star is not padding
            const Real there = value(star.link[i]);
            at[i] = there;
            next[i - 1] = there;
        }
        for (std::uint32_t i = n; i < star.padded(); ++i) {
            at[i + 1] = at[0];
            next[i] = next[0];
        }
    }
};

/// The minimum of value(q) + slope |p - q| over the points q of the link of a star, whose centre is
/// p; the value is linear along the link's edges. O(degree).
template <class Real>
Real min_over_link(const Star<Real>& star, Real slope, const LinkValues<Real>& values);

/// Whether the centre of a star is on the interface (or on a side of the domain that belongs to
/// it). O(1).
template <class Real>
bool is_on_interface(const Star<Real>& star) {
    return !star.one_phase || (!star.closed && star.phase[0] != exterior_phase);
}

/// Computes targets. Thread-safe if the functions of the application are.
template <class Real>
class SizeRule {
public:
    /// Refers to the options.
    SizeRule(const SizeOptions<Real>& options, Real edge_length)
        : options_(options), edge_length_(edge_length),
          shortest_(options.shortest > 0 ? options.shortest : edge_length),
          slope_(static_cast<Real>(options.growth) - 1),
          slack_(std::min(Real(0.1), Real(0.3) * slope_)) {}

    /// The growth of a target per unit of length.
    [[nodiscard]] Real slope() const { return slope_; }
    /// Changes by less than this fraction of the target are ignored. The slack does not stop two
    /// neighbours that limit each other: in each pass they rise by the slope times the edge between
    /// them, which is longer than 0.3 times their target.
    [[nodiscard]] Real slack() const { return slack_; }
    /// Whether targets depend on the distance to the interface, which is then stored.
    [[nodiscard]] bool needs_distance() const { return bool(options_.by_distance); }

    /// The target at the centre, regardless of its neighbours. O(degree).
    [[nodiscard]] Real own(const Star<Real>& star, Real distance, Real time) const {
        if (is_finest(star)) {
            return edge_length_;
        }
        Real lowest =
            options_.longest > 0 ? options_.longest : std::numeric_limits<Real>::infinity();
        for (std::uint32_t i = 0; options_.by_place && i < star.size; ++i) {
            if (i == 0 || star.phase[i] != star.phase[i - 1]) {
                const Point<Real> place(star.x0, star.y0);
                lowest = std::min(lowest, checked(options_.by_place(place, time, star.phase[i]),
                                                  "sizes.by_place", place));
            }
        }
        if (options_.on_interface && is_on_interface(star)) {
            lowest = std::min(lowest, on_interface({star.x0, star.y0}, time));
        }
        if (needs_distance()) {
            lowest = std::min(lowest, checked(options_.by_distance(distance), "sizes.by_distance",
                                              {star.x0, star.y0}));
        }
        return lowest;
    }

    /// The target of interface edges at a point; requires the option `on_interface`.
    [[nodiscard]] Real on_interface(const Point<Real>& place, Real time) const {
        return checked(options_.on_interface(place, time), "sizes.on_interface", place);
    }

    /// Whether the target is the edge length because the centre is on the interface. O(1).
    [[nodiscard]] bool is_finest(const Star<Real>& star) const {
        return !options_.by_place && !options_.on_interface && is_on_interface(star);
    }

    /// Whether a test without roots and quotients shows that `at` differs from a stored length by
    /// no more than the slack, and that a neighbour is lower. It does for most stars. O(degree).
    template <class Sizes>
    [[nodiscard]] bool stays(const Star<Real>& star, const Sizes& sizes, Real stored,
                             Real time) const {
        if (needs_distance() || !star.closed) {
            return false;
        }
        // A change to a target between these two is ignored, whatever its rounding.
        const Real lowest = stored / (1 + slack_) * Real(1 + 1e-5);
        const Real highest = stored * (1 + slack_) * Real(1 - 1e-5);
        const Real alone = own(star, 0, time);
        bool is_low_enough = alone <= highest;
        bool is_high_enough = alone >= lowest;
        bool is_above = false;
        Real here = sizes[star.link[0]].length;
        for (std::uint32_t i = 0; i < star.size; ++i) {
            const Real next = sizes[star.link[i + 1]].length;
            const Real ax = star.x[i] - star.x0;
            const Real ay = star.y[i] - star.y0;
            const Real bx = star.x_next[i] - star.x0;
            const Real by = star.y_next[i] - star.y0;
            const Real ex = bx - ax;
            const Real ey = by - ay;
            const Real incident_edge = slope_ * slope_ * (ax * ax + ay * ay);
            const Real room = highest - here;
            is_low_enough |= incident_edge <= room * std::abs(room);
            // No value on the edge is below that of its lower end, and no point is nearer than the
            // line through the edge.
            const Real across = slope_ * (ax * by - ay * bx);
            const Real lack = lowest - std::min(here, next);
            is_high_enough &= across * across >= lack * std::abs(lack) * (ex * ex + ey * ey);
            is_above |= here < stored;
            here = next;
        }
        return is_low_enough && is_high_enough && is_above;
    }

    /// The target at the centre, limited by the values of its neighbours in `sizes`. O(degree).
    template <class Sizes>
    [[nodiscard]] VertexSize<Real> at(const Star<Real>& star, const Sizes& sizes, Real time) const {
        LinkValues<Real> values;
        Real distance = 0;
        if (needs_distance() && !is_on_interface(star)) {
            values.take(star, [&](std::uint32_t v) { return sizes[v].distance; });
            distance = min_over_link(star, Real(1), values);
        }
        values.take(star, [&](std::uint32_t v) { return sizes[v].length; });
        const Real lowest = own(star, distance, time);
        return {std::min(lowest, min_over_link(star, slope_, values)), distance};
    }

private:
    // Checks the length that a function of the application returned for a point.
    [[nodiscard]] Real checked(Real length, const char* name, const Point<Real>& place) const {
        if (!(length > 0)) [[unlikely]] {
            throw InputError({.what = "not a length",
                              .where = name,
                              .value = to_text(length) + " at " + to_text(place),
                              .allowed = "above 0; infinity for no bound"});
        }
        return std::max(length, shortest_);
    }

    const SizeOptions<Real>& options_;
    Real edge_length_;
    Real shortest_;
    Real slope_;
    Real slack_;
};

} // namespace dsc
