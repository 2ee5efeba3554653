// SPDX-License-Identifier: MIT
// When the fronts about a film would arrive at a place in it.
#pragma once

#include "topology/region.h"

#include <array>
#include <span>
#include <vector>

namespace dsc {

/// The fronts beside a part of a film: the sheets of its triangles. It knows their positions and
/// speeds by value, so it remains valid when edges of the film are split.
template <class Real>
class Arrival {
public:
    /// O(number of triangles).
    Arrival(const TopologyWork<Real>& work, std::span<const Triangle> part);

    /// How far the nearest front of the phase is from the place, in units of the domain; faster
    /// fronts are nearer in proportion. Vertices that are ahead of their front lengthen its way,
    /// and a front that ends on the domain boundary goes on straight beyond it. Infinite if the
    /// phase has no front here. O(sheets).
    [[nodiscard]] Real way_of(Phase front, const Point<Real>& place) const;
    /// How far a front of mean speed goes in a sub-step; 0 if nobody knows.
    [[nodiscard]] Real mean_speed() const { return mean_speed_; }

private:
    struct Front {
        Phase phase;
        Point<Real> from;
        Point<Real> way;
        std::array<bool, 2> is_end; ///< of the front, on the domain boundary
        std::array<Real, 2> leads;  ///< by which the ends of the sheet are ahead of the front
        Real speed;                 ///< in a sub-step; 0: unknown
    };

    [[nodiscard]] Front front_at(const TopologyWork<Real>& work, Corner sheet) const;

    std::vector<Front> fronts_;
    Real mean_speed_ = 0;
};

} // namespace dsc
