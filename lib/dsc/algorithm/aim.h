// SPDX-License-Identifier: MIT
// Where the interface goes: velocities and targets of the interface vertices of one work
// (algorithm 5.1, line 4). The sequential driver aims for the whole complex at once, the parallel
// one for each submesh.
#pragma once

#include "dsc/algorithm/work.h"

namespace dsc {

/// What is known once all targets are.
template <class Real>
struct AimReport {
    Real fastest = 0;         ///< the largest finite speed at the start
    Real farthest = 0;        ///< the longest way to a target
    std::uint64_t held = 0;   ///< vertices held for a velocity that is not finite
    std::size_t vertices = 0; ///< interface vertices

    AimReport& operator+=(const AimReport& other);
};

/// Velocities at `time` of `work.interface`, into `work.aim`. O(interface vertices).
template <class Real>
AimReport<Real> find_velocities(Work<Real>& work, const Velocity<Real>& velocity, Real time);

/// Their targets at time + dt, from these velocities; returns the longest way. O(interface
/// vertices), as often as the driver changes its mind about dt.
template <class Real>
Real find_targets(Work<Real>& work, const Velocity<Real>& velocity, Real time, Real dt);

/// Puts those that have somewhere to go into `work.movers`; returns how many are held for a target
/// that is not finite. Locked vertices stay.
template <class Real>
std::uint64_t collect_movers(Work<Real>& work);

} // namespace dsc
