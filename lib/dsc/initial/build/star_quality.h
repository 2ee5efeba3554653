// SPDX-License-Identifier: MIT
// Quality of stars as they are and as they would become, by the measure of the thesis, section 4.3,
// equation 4. In doubles, since the improvement compares values that lie close together.
#pragma once

#include "dsc/base/verdict.h"
#include "dsc/complex/gather.h"
#include "dsc/geometry/predicates.h"
#include "dsc/initial/build/insertion.h"
#include "dsc/operations/edge_collapse.h"
#include "dsc/quality/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc::initial {

/// The worst triangle of the star if its centre were at `centre`.
template <class Real>
double worst_quality_at(const Star<Real>& star, const Point<double>& centre) {
    double worst = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < star.size; ++i) {
        const Point<double> p(star.x[i], star.y[i]);
        const Point<double> q(star.x_next[i], star.y_next[i]);
        worst = std::min(worst, quality<double>(centre, p, q));
    }
    return worst;
}

template <class Real>
double worst_quality(const Star<Real>& star) {
    return worst_quality_at(star, Point<double>(star.x0, star.y0));
}

/// The neighbour into which the centre of a star is collapsed.
struct CollapseChoice {
    std::uint32_t incident_edge = no_id; ///< none is legal
    double quality = 0;                  ///< of the worst triangle afterwards
};

/// The neighbour that leaves the best worst triangle and no incident edge longer than `longest`.
/// For a star inside one phase; a vertex of the domain boundary may only go to its neighbours
/// there.
template <class Real>
CollapseChoice best_collapse(const Star<Real>& star,
                             double longest = std::numeric_limits<double>::infinity()) {
    CollapseChoice best;
    const std::uint32_t n = star.size;
    for (std::uint32_t k = 0; k < star.link_size(); ++k) {
        if (!star.closed && k != 0 && k != n) {
            continue;
        }
        const Point<double> target(star.link_x(k), star.link_y(k));
        double worst = std::numeric_limits<double>::infinity();
        for (std::uint32_t i = 0; i < n && worst > best.quality; ++i) {
            const bool vanishes = i == k || i + 1 == k || (star.closed && k == 0 && i + 1 == n);
            if (vanishes) {
                continue;
            }
            const Point<double> p(star.x[i], star.y[i]);
            const Point<double> q(star.x_next[i], star.y_next[i]);
            const double length = std::max((p - target).norm(), (q - target).norm());
            worst = length > longest || orientation<double>(target, p, q) <= 0
                        ? 0
                        : std::min(worst, quality<double>(target, p, q));
        }
        if (worst > best.quality && std::isfinite(worst)) {
            best = {k, worst};
        }
    }
    return best;
}

/// Collapses the centre of a star into the link vertex at the end of this incident edge, if there
/// is one and that is legal, and restores the Delaunay property. Returns whether it was.
template <class Real>
bool collapse_along(Complex<Real>& complex, const Star<Real>& star, std::uint32_t incident_edge,
                    std::vector<Corner>& stack) {
    if (incident_edge == no_id) {
        return false;
    }
    // An incident edge is opposite to the previous corner of the triangle that begins with it; the
    // last one of an open star to the next corner of the triangle that ends there.
    const bool last = incident_edge == star.size;
    const Corner corner =
        last ? next(star.corner[star.size - 1]) : prev(star.corner[incident_edge]);
    const auto end = last ? rewire::Vanishing::prev : rewire::Vanishing::next;
    if (edge_collapse(Submesh(complex), corner, end) != Verdict::legal) {
        return false;
    }
    legalise_star(complex, star.link[incident_edge], stack);
    return true;
}

} // namespace dsc::initial
