// SPDX-License-Identifier: MIT
// Movement (thesis, section 5.1): one vertex towards its target, as far as its star allows. The
// doubled area of a star triangle is linear in the fraction travelled, so the limit is a division
// per triangle.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/rewire.h"
#include "dsc/complex/submesh.h"
#include "dsc/quality/measures.h"

namespace dsc {

/// A move leaves each triangle an altitude of at least this share of the base that does not move...
inline constexpr double altitude_floor = 0.02;
/// ...or, if its altitude was lower than that before the move, this share of that altitude.
inline constexpr double altitude_keep = 0.5;

/// The largest fraction in [0, 1] of the way to (x, y) for which every star triangle keeps an
/// altitude of `altitude_floor` times its base, or `altitude_keep` of its present altitude; 0 if
/// (x, y) is not finite. O(degree).
template <class Real>
Real move_limit(const Star<Real>& star, Real x, Real y) {
    const Real dx = x - star.x0;
    const Real dy = y - star.y0;
    Real limit = 1;
    const std::uint32_t n = star.padded();
    constexpr auto floor = static_cast<Real>(altitude_floor);
    constexpr auto keep = static_cast<Real>(altitude_keep);
    constexpr Real tiny = std::numeric_limits<Real>::min();
#pragma omp simd reduction(min : limit)
    for (std::uint32_t i = 0; i < n; ++i) {
        const Real ax = star.x[i] - star.x0;
        const Real ay = star.y[i] - star.y0;
        const Real bx = star.x_next[i] - star.x0;
        const Real by = star.y_next[i] - star.y0;
        const Real cx = bx - ax;
        const Real cy = by - ay;
        const Real area = ax * by - ay * bx;
        const Real rate = cx * dy - cy * dx; // the area's derivative by the fraction
        const Real base = cx * cx + cy * cy;
        const Real spare = area - std::min(floor * base, keep * area);
        limit = std::min(limit, spare / std::max(-rate, tiny));
    }
    // `std::min` ignores NaN.
    return std::isfinite(dx) && std::isfinite(dy) ? std::max(limit, Real(0)) : Real(0);
}

/// How far a vertex moved.
enum class MoveOutcome : std::uint8_t {
    reached, ///< the vertex is at its target
    partly,  ///< it moved part of the way
    blocked, ///< it could not move at all
};

/// Moves by less than this fraction of the way are not made, because rounding would outweigh them.
inline constexpr double min_fraction = 1e-3;

/// A vertex counts as arrived once it is this near to its target: so many units in the last place
/// of the target's largest coordinate, or of the edge length if that is larger. A target is the sum
/// of several rounded terms, so that a shorter distance says nothing.
inline constexpr int arrival_units = 8;

/// Whether a vertex has arrived at its target, up to rounding. Two sheets of the interface whose
/// targets coincide never meet there exactly: each move takes a vertex about half of the distance
/// that is left. Without this test such vertices would count as unreached. O(1).
template <class Real>
bool is_at(const Point<Real>& position, const Point<Real>& target, Real edge_length) {
    const Real scale = std::max(target.cwiseAbs().maxCoeff(), edge_length);
    const Real unit = arrival_units * std::numeric_limits<Real>::epsilon() * scale;
    return (target - position).cwiseAbs().maxCoeff() <= unit;
}

/// Moves the star's vertex towards (x, y). The star's own centre is updated. O(degree).
template <class Real>
MoveOutcome move_vertex(const Submesh<Real>& submesh, Star<Real>& star, Real x, Real y,
                        MoveReason reason = MoveReason::flow) {
    Real fraction = move_limit(star, x, y);
    for (int attempt = 0; attempt < 4; ++attempt, fraction *= Real(0.5)) {
        if (!(fraction >= static_cast<Real>(min_fraction))) {
            break;
        }
        const bool whole = fraction >= 1;
        const Real px = whole ? x : star.x0 + fraction * (x - star.x0);
        const Real py = whole ? y : star.y0 + fraction * (y - star.y0);
        if (px == star.x0 && py == star.y0 && !whole) {
            break; // rounds to the old position: no progress
        }
        if (all_positive(star, px, py)) {
            rewire::move(submesh.complex, *submesh.log, star.vertex, px, py, reason);
            star.x0 = px;
            star.y0 = py;
            return whole ? MoveOutcome::reached : MoveOutcome::partly;
        }
    }
    return MoveOutcome::blocked;
}

} // namespace dsc
