// SPDX-License-Identifier: MIT
// Options of a simulation. Lengths are relative to `edge_length`; qualities are those of
// geometry/tet.h.
#pragma once

#include "dsc3/motion/insertion.h"
#include "dsc3/motion/integrator.h"

namespace dsc3 {

/// Thresholds of the interface.
struct InterfaceThresholds {
    double longest = 1.4;   ///< longer edges are split
    double shortest = 0.45; ///< shorter edges are collapsed
    /// ...if the removed vertex lies within this distance of the new interface, on junction curves
    /// within a twentieth of it,
    double deviation = 0.005;
    double always = 0.15; ///< or the edge is shorter than this
};

/// Options of a simulation.
struct Options {
    Real edge_length = 0; ///< target length of interface edges, in units of the domain; positive

    InterfaceThresholds interface = {}; ///< of all interfaces

    double quality = 0.25;     ///< changed tets below this quality are improved
    double move_quality = 0.1; ///< moves keep tets above this quality, if they were
    int layers = 3;            ///< of vertices beside the interface that move along with it

    Integrator integrator = Integrator::rk4; ///< how targets are found from velocities
    double tolerance = 1e-4; ///< of `adaptive`: largest error of a sub-step, in edge lengths
    InsertionFunction insertion = curved_middle; ///< where new interface vertices go

    double sub_step = 0.4;     ///< largest displacement in a sub-step, in edge lengths
    int max_sub_steps = 10000; ///< of one step; a step that needs more gives up and reports it
    int max_passes = 16;       ///< of movement and mesh repair, of one sub-step
};

/// Throws InputError if a value is not finite, out of range, or inconsistent with another.
void check_options(const Options& options);

} // namespace dsc3
