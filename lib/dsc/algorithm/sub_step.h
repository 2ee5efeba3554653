// SPDX-License-Identifier: MIT
// The parts of a sub-step: where the interface moves (thesis, algorithm 5.1, line 4), and the
// movement. The sequential driver runs them for the whole complex at once, the parallel one for
// each submesh.
#pragma once

#include "dsc/passes/algorithm.h"
#include "dsc/passes/work.h"

#include <algorithm>
#include <vector>

namespace dsc {

/// The distances of targets, and their errors.
template <class Real>
struct Reach {
    Real farthest = 0; ///< largest distance of a vertex to its finite target
    Real error = 0;    ///< the largest error estimate, a length, of an integrator that has one
    Vertex where = {}; ///< the first vertex with this error

    Reach& operator+=(const Reach& other) {
        farthest = std::max(farthest, other.farthest);
        if (other.error > error) {
            error = other.error;
            where = other.where;
        }
        return *this;
    }
};

/// A summary of the targets of a sub-step.
template <class Real>
struct TargetReport {
    Real fastest = 0;         ///< the largest finite speed at the start
    Vertex where;             ///< the first vertex that has it
    Reach<Real> reach;        ///< of the targets
    std::uint64_t held = 0;   ///< vertices held because of a velocity that is not finite
    std::size_t vertices = 0; ///< interface vertices

    TargetReport& operator+=(const TargetReport& other);
};

/// The result of a movement.
struct MoveReport {
    std::uint32_t passes = 0;    ///< of movement and mesh update; the largest of all submeshes
    std::uint64_t unreached = 0; ///< vertices that did not arrive
    std::uint64_t held = 0;      ///< vertices held because of a target that is not finite

    MoveReport& operator+=(const MoveReport& other);
};

/// Stores the positions of `work.interface`, marks no vertex as held, and makes room for the
/// targets. O(interface vertices).
template <class Real>
void begin_targets(Work<Real>& work);

/// Finds the velocities of `work.interface` at `time`, and from these its targets at time + dt;
/// both in `work.trajectory`. O(interface vertices).
template <class Real>
TargetReport<Real> targets_along(Work<Real>& work, const Velocity<Real>& velocity, Real time,
                                 Real dt);

/// Finds the targets for another dt from the same velocities. O(interface vertices).
template <class Real>
Reach<Real> find_targets(Work<Real>& work, const Velocity<Real>& velocity, Real time, Real dt);

/// Puts the vertices that have to move into `work.moving_vertices`; returns how many are held
/// because their target is not finite. Locked vertices stay. A custom integrator is then told to
/// `accept` the targets.
template <class Real>
std::uint64_t collect_moving_vertices(Work<Real>& work);

/// True once a vertex has missed its target three times in a row: it is blocked, and further
/// attempts would fail.
template <class Real>
bool is_in_contact(const VertexRecord<Real>& record) {
    return (record.flags & vertex_contact) == vertex_contact;
}

/// Notes for each remaining moving vertex that it did not arrive, and returns their number. Deleted
/// ones, and those within rounding of their targets, are dropped first.
template <class Real>
std::uint64_t give_up_moving_vertices(Work<Real>& work);

/// Repeats the motion passes over `work.moving_vertices` until all have arrived except those in
/// contact, for at most `max_passes`, and at most `max_idle_passes` without any progress.
/// `next_epoch` gives the stamp of the next pass. Returns the number of passes run; vertices that
/// did not arrive are left in `work.moving_vertices`.
template <class Real>
std::uint32_t run_motion(Work<Real>& work, const std::vector<Pass<Real>>& passes,
                         std::uint32_t& next_epoch);

/// Increments `last` and returns it as a new stamp. After the largest stamp, in 2^32 passes, all
/// vertices lose their stamps and numbering starts again: O(mesh). Must not run beside other
/// submeshes.
template <class Real>
std::uint32_t next_stamp(Complex<Real>& complex, std::uint32_t& last);

/// Removes all stamps, so that stamps of another run are not mistaken for this one's. O(mesh).
template <class Real>
void clear_stamps(Complex<Real>& complex);

} // namespace dsc
