// SPDX-License-Identifier: MIT
// What a pass works on: a submesh, the interface vertices that lie in it, the active set (the
// vertices whose star changed), and the log of its edits. The sequential driver has one, the
// parallel driver one for each submesh. Nothing here grows with the mesh.
#pragma once

#include "dsc/complex/ring.h"
#include "dsc/complex/submesh.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/options.h"

#include <vector>

namespace dsc {

/// Where the vertices of `Work::interface` are, and where they should move; one entry for each.
template <class Real>
struct Aim {
    std::vector<Point<Real>> positions; ///< now
    std::vector<Point<Real>> targets;   ///< at the end of the sub-step
    std::vector<std::uint8_t> held;     ///< not 0: the velocity is not finite, the vertex stays
    IntegratorScratch<Real> scratch;    ///< `first`: the velocities
    Real dt = 0;                        ///< the time in which the targets are to be reached
};

/// What one submesh holds while a step runs.
template <class Real>
struct Work {
    /// Refers to both: the executor that owns the work keeps a copy of the options.
    Work(Complex<Real>& complex_in, const Options<Real>& options_in)
        : complex(complex_in),
          options(options_in), submesh{complex_in, Region{}, complex_in.ids, log} {}
    ~Work() = default;
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
    Work(Work&&) = delete;
    Work& operator=(Work&&) = delete;

    Complex<Real>& complex;       ///< the complex that is worked on
    const Options<Real>& options; ///< those of the simulation
    EditLog log;                  ///< the edits made here
    Submesh<Real> submesh;        ///< notes in `log`

    std::vector<std::uint32_t> interface; ///< interface vertices, roughly in the order of the curve
    Aim<Real> aim;                        ///< of the interface vertices
    std::vector<Mover<Real>> movers;      ///< vertices that have not reached their target yet
    std::vector<std::uint32_t> active;    ///< vertices whose star must be looked at; no duplicates
    std::uint32_t epoch = 0;              ///< a vertex with this stamp is in `active` already
    /// Vertices to be looked at in the next mesh update because the target length of edges changes
    /// there, or because vertices had yet to arrive (waiting.h); with duplicates.
    std::vector<std::uint32_t> resized;

    Real time = 0; ///< at the start of the sub-step
    /// What the sub-step is expected to last; it may become shorter or, if the flow turns out to be
    /// slower than in the last one, longer.
    Real dt = 0;

    /// What the submesh boundary kept this submesh from doing: left to another colour (the
    /// submeshes that run at another time).
    DeferredQueue<Real> deferred;

    /// Changes of the interface by passes of an application: see `run_pass`.
    std::vector<std::uint32_t> changed_interface;

    std::size_t progressed = 0; ///< movers that made any progress in the last movement pass
    std::size_t arrived = 0;    ///< movers of these that reached their targets

    // Scratch, kept so that nothing is allocated from step to step.
    Ring<Real> ring;                           ///< the star under examination
    Ring<Real> other_ring;                     ///< and a second one
    std::vector<Corner> suspects;              ///< edges to be tested for the Delaunay condition
    std::vector<std::uint32_t> interface_next; ///< of the interface list, while it is rebuilt
    std::vector<std::uint32_t> changed;        ///< on the interface, by the pass that was run last

    /// Puts a vertex into the active set, unless it is there already.
    void activate(std::uint32_t vertex) {
        auto& record = complex.vertices[vertex];
        if (record.stamp != epoch) {
            record.stamp = epoch;
            active.push_back(vertex);
        }
    }
};

} // namespace dsc
