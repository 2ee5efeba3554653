// SPDX-License-Identifier: MIT
// Where the interface goes: velocities and targets of the interface vertices of one work
// (algorithm 5.1, line 4). The sequential driver aims for the whole complex at once, the parallel
// one for each submesh.
#pragma once

#include "dsc/passes/work.h"

#include <algorithm>

namespace dsc {

/// How far the targets are.
template <class Real>
struct Reach {
    Real farthest = 0; ///< the longest way to a target that is finite
    Real error = 0;    ///< the largest estimate of an integrator that has one, a length

    Reach& operator+=(const Reach& other) {
        farthest = std::max(farthest, other.farthest);
        error = std::max(error, other.error);
        return *this;
    }
};

/// What is known once all targets are.
template <class Real>
struct AimReport {
    Real fastest = 0; ///< the largest finite speed at the start
    Reach<Real> reach;
    std::uint64_t held = 0;   ///< vertices held for a velocity that is not finite
    std::size_t vertices = 0; ///< interface vertices

    AimReport& operator+=(const AimReport& other);
};

/// Velocities at `time` of `work.interface`, into `work.aim`. O(interface vertices).
template <class Real>
AimReport<Real> find_velocities(Work<Real>& work, const Velocity<Real>& velocity, Real time);

/// Their targets at time + dt, from these velocities. O(interface vertices), as often as the driver
/// changes its mind about dt.
template <class Real>
Reach<Real> find_targets(Work<Real>& work, const Velocity<Real>& velocity, Real time, Real dt);

/// Puts those that have somewhere to go into `work.movers`; returns how many are held for a target
/// that is not finite. Locked vertices stay. What `centred` remembers is brought up to date.
template <class Real>
std::uint64_t collect_movers(Work<Real>& work);

} // namespace dsc
