// SPDX-License-Identifier: MIT
// The state that passes work on: one for the whole complex, or one for each submesh.
#pragma once

#include "dsc/base/archive.h"
#include "dsc/base/types.h"
#include "dsc/complex/cached_star.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/submesh.h"
#include "dsc/motion/integrator.h"
#include "dsc/passes/deferred.h"
#include "dsc/passes/options.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace dsc {

/// The positions and targets of the vertices of `Work::interface`; one entry for each.
template <class Real>
struct Trajectory {
    std::vector<Point<Real>> positions; ///< now
    std::vector<Point<Real>> targets;   ///< at the end of the sub-step
    std::vector<std::uint8_t> held;     ///< not 0: the velocity is not finite, the vertex stays
    IntegratorScratch<Real> scratch;    ///< `first`: the velocities
    Real dt = 0;                        ///< the time in which vertices move to the targets
};

template <class Real>
struct Pass;

/// The state of one submesh during a step, on which passes work: the interface vertices that lie in
/// it, the active set (the vertices whose star changed), the log of its edits, and the work that it
/// defers to another submesh. The sequential driver has one, the parallel driver one for each
/// submesh. Nothing here grows with the mesh.
template <class Real>
struct Work : Unmovable {
    /// Keeps references to both; the executor that owns the work keeps a copy of the options.
    Work(Complex<Real>& complex_in, const Options<Real>& options_in)
        : complex(complex_in),
          options(options_in), submesh{complex_in, Region{}, complex_in.ids, log} {}

    Complex<Real>& complex;       ///< the complex on which the passes work
    const Options<Real>& options; ///< those of the simulation
    EditLog log;                  ///< the edits made here
    Submesh<Real> submesh;        ///< notes in `log`

    std::vector<std::uint32_t> interface; ///< interface vertices, roughly in the order of the curve
    Trajectory<Real> trajectory;          ///< of the interface vertices
    std::vector<MovingVertex<Real>> moving_vertices; ///< not at their targets yet
    /// Stars that the interface remeshing has not changed, in the order of `interface`, so that
    /// movement need not gather them again. Invalid once a pass of motion has run.
    std::vector<CachedStar> stars;
    std::vector<std::uint32_t> active; ///< vertices whose star must be visited; no duplicates
    std::uint32_t epoch = 0;           ///< a vertex with this stamp is in `active` already
    /// Squared quality at or below which the mesh update lists a star in `poor`; -1: never.
    double watched_quality = -1;
    /// Vertices whose stars have triangles of that quality after the mesh update, or were not
    /// examined after their last edit; with duplicates.
    std::vector<std::uint32_t> poor;
    /// Vertices to be visited in the next mesh update because the target length of edges changes
    /// there, or because vertices had yet to arrive (waiting.h); with duplicates.
    std::vector<std::uint32_t> resized;

    Real time = 0; ///< at the start of the sub-step
    /// The expected duration of the sub-step; it may become shorter or, if the flow is slower than
    /// in the last one, longer.
    Real dt = 0;

    /// Work that the submesh boundary prevented: deferred to another colour (the submeshes that run
    /// at another time).
    DeferredQueue<Real> deferred;

    /// Changes of the interface by passes of an application: see `run_pass`.
    std::vector<std::uint32_t> changed_interface;

    /// The executor's passes of remeshing; the first one shows its stars to passes with a `watch`.
    std::span<const Pass<Real>> remeshing;

    std::size_t progressed = 0; ///< moving vertices that moved in the last pass
    std::size_t arrived = 0;    ///< number of these that reached them

    // Scratch, kept so that nothing is allocated from step to step.
    Star<Real> star;                           ///< the star under examination
    Star<Real> other_star;                     ///< and a second one
    std::vector<Corner> candidates;            ///< edges to be tested for the Delaunay condition
    std::vector<std::uint32_t> interface_next; ///< of the interface list, while it is rebuilt
    std::vector<std::uint32_t> changed;        ///< vertices that the last pass put on the
                                               ///< interface, or took off

    /// Puts a vertex into the active set, unless it is there already.
    void activate(std::uint32_t vertex) {
        auto& record = complex.vertices[vertex];
        if (record.stamp != epoch) {
            record.stamp = epoch;
            active.push_back(vertex);
        }
    }
};

/// Archives the interface, the active set and other data that the next step needs; the rest of a
/// work is scratch, or empty between two steps. Call after reading the complex: throws FileError
/// for an id that it does not have.
template <class Real>
void archive(Archive& archive, Work<Real>& work) {
    archive(work.interface, work.active, work.resized, work.epoch, work.time, work.dt);
    for (const auto* list : {&work.interface, &work.active, &work.resized}) {
        expect_vertices<Real>(archive, work.complex, *list);
    }
    for (const std::uint32_t v : work.interface) {
        archive.expect(work.complex.is_alive(Vertex{v}), "interface vertex that is not alive");
    }
}

} // namespace dsc
