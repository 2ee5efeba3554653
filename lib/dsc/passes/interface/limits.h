// SPDX-License-Identifier: MIT
// The lengths that the interface remeshing allows: relative to the edge length, to the target at a
// place, and to the shape of the curve there.
#pragma once

#include "dsc/geometry/side.h"
#include "dsc/passes/boundary.h"
#include "dsc/passes/interface/curve.h"
#include "dsc/passes/work.h"
#include "dsc/queries/phases.h"
#include "dsc/sizes/rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dsc {

/// Lengths are squared, and relative to the target at a place: see `stretch`. Made for one run of
/// the remeshing, whose options and time it reads.
template <class Real>
struct InterfaceLimits {
    explicit InterfaceLimits(const Work<Real>& work)
        : options(work.options), time(work.time), longest(square(thresholds().longest)),
          shortest(square(thresholds().shortest)),
          bypass(square(thresholds().longest + thresholds().shortest)),
          deviation(square(thresholds().deviation)),
          degenerate(square(thresholds().degenerate * thresholds().deviation)),
          gap(static_cast<Real>(thresholds().gap * thresholds().gap)),
          finest(square(2 * thresholds().finest)),
          turn(static_cast<Real>(std::pow(thresholds().turn_degrees * std::numbers::pi / 180, 2))),
          sizes(work.options.sizes, work.options.edge_length),
          // A boundary edge ahead of an end that is shorter than a sub-step blocks the motion, so
          // it is collapsed even if a triangle becomes poor for a while.
          boundary{square(options.phases.longest), square(options.sub_step), Real(0.05),
                   square(std::min(options.sub_step, options.phases.longest / 2))} {}

    /// The square of the target of interface edges at a place, over that of the edge length.
    Real stretch(const Point<Real>& place) const {
        if (!options.sizes.on_interface) {
            return 1;
        }
        const Real ratio = sizes.on_interface(place, time) / options.edge_length;
        return ratio * ratio;
    }

    /// The largest length of an interface edge; `local` is the limit by the shape at one end.
    Real allowed(Real local, const Point<Real>& from, const Point<Real>& to) const {
        const Real here = longest * stretch(midpoint<Real>(from, to));
        return local < longest ? std::min(local, here) : here;
    }

    /// The largest length of interface edges at the centre of a star, by the shape there.
    Real by_shape(const Complex<Real>& complex, const Star<Real>& star,
                  const IncidentEdges& incident) const {
        if (!(turn > 0 || gap > 0) || incident.count != 2) {
            return longest;
        }
        Real found = longest;
        // The angle at which a curve meets the domain boundary is not a bend of the curve.
        if (turn > 0 && star.closed && !complex.is_feature(Vertex{star.vertex})) {
            const Real bend = curvature<Real>(link_point(star, incident.first), {star.x0, star.y0},
                                              link_point(star, incident.second));
            found = std::min(found, turn / (bend * bend));
        }
        if (gap > 0) {
            found = std::min(found, gap * squared_gap(complex, star, incident));
        }
        return std::max(found, finest);
    }

    /// If the interface is finer than the edge length, boundary edges are as fine as the interface.
    BoundaryLimits<Real> on_boundary(const Star<Real>& star) const {
        const Real share = std::min(Real(1), stretch({star.x0, star.y0}));
        return {share * boundary.longest, share * boundary.shortest, boundary.min_quality,
                share * boundary.blocking};
    }

    const Options<Real>& options;
    Real time;
    Real longest;
    Real shortest;
    Real bypass; ///< of an edge that is merged to let an end of the curve pass
    Real deviation;
    Real degenerate;
    Real gap;    ///< a share, squared, of the gap to the next sheet; 0: gaps are not looked at
    Real finest; ///< whatever the shape
    Real turn;   ///< an angle, squared
    SizeRule<Real> sizes;
    BoundaryLimits<Real> boundary;

private:
    const InterfaceThresholds& thresholds() const { return options.interface; }
    Real square(double relative) const {
        const Real value = static_cast<Real>(relative) * options.edge_length;
        return value * value;
    }
};

} // namespace dsc
