// SPDX-License-Identifier: MIT
// Where the interface moves: velocities and targets of the interface vertices of one work (thesis,
// algorithm 5.1, line 4). The sequential driver aims for the whole complex at once, the parallel
// one for each submesh.
#pragma once

#include "dsc/passes/work.h"

#include <algorithm>

namespace dsc {

/// How far away the targets are.
template <class Real>
struct Reach {
    Real farthest = 0; ///< the longest distance to a finite target
    Real error = 0;    ///< the largest error estimate, a length, of an integrator that has one

    Reach& operator+=(const Reach& other) {
        farthest = std::max(farthest, other.farthest);
        error = std::max(error, other.error);
        return *this;
    }
};

/// What is known once all targets have been found.
template <class Real>
struct AimReport {
    Real fastest = 0;         ///< the largest finite speed at the start
    Reach<Real> reach;        ///< of the targets
    std::uint64_t held = 0;   ///< vertices held because of a velocity that is not finite
    std::size_t vertices = 0; ///< interface vertices

    AimReport& operator+=(const AimReport& other);
};

/// Finds the velocities of `work.interface` at `time` and stores them in `work.aim`. O(interface
/// vertices).
template <class Real>
AimReport<Real> find_velocities(Work<Real>& work, const Velocity<Real>& velocity, Real time);

/// Finds their targets at time + dt from these velocities. O(interface vertices); called again
/// whenever the driver changes dt.
template <class Real>
Reach<Real> find_targets(Work<Real>& work, const Velocity<Real>& velocity, Real time, Real dt);

/// Puts the vertices that have to move into `work.movers`; returns how many are held because their
/// target is not finite. Locked vertices stay. A custom integrator is told which targets these are.
template <class Real>
std::uint64_t collect_movers(Work<Real>& work);

} // namespace dsc
