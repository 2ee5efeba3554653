// SPDX-License-Identifier: MIT
// Quality of stars as they are and as they would become, by the measure of thesis 4.3, equation 4.
#pragma once

#include "dsc/base/predicates.h"
#include "dsc/complex/ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc::initial {

/// 2/sqrt(3) sin(smallest angle): 1 for an equilateral triangle, 0 or less for one without area.
/// In doubles, since the improvement compares values that lie close together.
inline double triangle_quality(double ax, double ay, double bx, double by, double cx, double cy) {
    const double ux = bx - ax;
    const double uy = by - ay;
    const double vx = cx - ax;
    const double vy = cy - ay;
    const double wx = cx - bx;
    const double wy = cy - by;
    const double u = std::sqrt(ux * ux + uy * uy);
    const double v = std::sqrt(vx * vx + vy * vy);
    const double w = std::sqrt(wx * wx + wy * wy);
    // The smallest angle lies between the two longer edges.
    const double product = std::max(std::max(u * v, v * w), w * u);
    return product > 0 ? 1.1547005383792515 * (ux * vy - uy * vx) / product : 0.0;
}

/// The worst triangle of the star if its centre were at (x, y).
template <class Real>
double worst_quality_at(const Ring<Real>& ring, double x, double y) {
    double worst = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        worst = std::min(worst, triangle_quality(x, y, static_cast<double>(ring.x[i]),
                                                 static_cast<double>(ring.y[i]),
                                                 static_cast<double>(ring.x_next[i]),
                                                 static_cast<double>(ring.y_next[i])));
    }
    return worst;
}

template <class Real>
double worst_quality(const Ring<Real>& ring) {
    return worst_quality_at(ring, static_cast<double>(ring.x0), static_cast<double>(ring.y0));
}

/// Whether the centre may be at this point: every star triangle strictly positive, exactly.
template <class Real>
bool fits(const Ring<Real>& ring, const Point<Real>& point) {
    for (std::uint32_t i = 0; i < ring.size; ++i) {
        if (orientation<Real>(point, {ring.x[i], ring.y[i]}, {ring.x_next[i], ring.y_next[i]}) <=
            0) {
            return false;
        }
    }
    return true;
}

/// Into which neighbour to collapse the centre of a star.
struct CollapseChoice {
    std::uint32_t spoke = no_id; ///< none is legal
    double quality = 0;          ///< of the worst triangle afterwards
};

/// The neighbour that leaves the best worst triangle and no spoke longer than `longest`. For a star
/// inside one phase; a vertex of the domain boundary may only go to its neighbours there.
template <class Real>
CollapseChoice best_collapse(const Ring<Real>& ring,
                             double longest = std::numeric_limits<double>::infinity()) {
    CollapseChoice best;
    const std::uint32_t n = ring.size;
    for (std::uint32_t k = 0; k < ring.link_size(); ++k) {
        if (!ring.closed && k != 0 && k != n) {
            continue;
        }
        const Point<Real> target(ring.link_x(k), ring.link_y(k));
        double worst = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < n && worst > best.quality; ++i) {
            const bool vanishes = i == k || i + 1 == k || (ring.closed && k == 0 && i + 1 == n);
            if (vanishes) {
                continue;
            }
            const Point<Real> p(ring.x[i], ring.y[i]);
            const Point<Real> q(ring.x_next[i], ring.y_next[i]);
            const double length = std::max(static_cast<double>((p - target).norm()),
                                           static_cast<double>((q - target).norm()));
            if (length > longest || orientation<Real>(target, p, q) <= 0) {
                worst = 0;
                break;
            }
            worst = std::min(worst, triangle_quality(static_cast<double>(target.x()),
                                                     static_cast<double>(target.y()),
                                                     static_cast<double>(p.x()),
                                                     static_cast<double>(p.y()),
                                                     static_cast<double>(q.x()),
                                                     static_cast<double>(q.y())));
        }
        if (worst > best.quality && std::isfinite(worst)) {
            best = {k, worst};
        }
    }
    return best;
}

} // namespace dsc::initial
