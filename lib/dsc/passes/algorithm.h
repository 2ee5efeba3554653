// SPDX-License-Identifier: MIT
// Algorithm 5.1 of the thesis as a list of passes, and what a pass works on. An application
// replaces, removes or adds passes without touching the drivers; both drivers run the same list: on
// the whole complex, or on each submesh.
#pragma once

#include "dsc/base/types.h"
#include "dsc/complex/cached_star.h"
#include "dsc/complex/complex.h"
#include "dsc/complex/gather.h"
#include "dsc/complex/submesh.h"
#include "dsc/passes/options.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace dsc {

/// A vertex that is moving to its target.
template <class Real>
struct MovingVertex {
    std::uint32_t vertex; ///< its id
    Real x;               ///< target
    Real y;
    std::uint32_t star = no_id; ///< number of its star in `Work::stars`
};

/// What is left to be done.
enum class DeferredKind : std::uint8_t {
    star,          ///< a star that must be looked at
    moving_vertex, ///< a vertex that has yet to reach its target
    remeshing,     ///< an interface vertex at which the interface may have to be split or collapsed
    listing, ///< an interface vertex that lies in another submesh now, whose list it belongs to
};

/// One entry of the queue.
template <class Real>
struct Deferred {
    /// The route of an entry that no submesh takes: it is left to what runs after all of them.
    static constexpr std::uint32_t nowhere = 0xffffffffU;

    std::uint32_t vertex;          ///< the vertex concerned
    std::uint32_t route = nowhere; ///< number of the submesh that takes it
    Real x = 0;                    ///< target of a moving vertex
    Real y = 0;
    DeferredKind kind; ///< what is to be done there

    /// The vertex and its target; only of the kind `moving_vertex`.
    [[nodiscard]] MovingVertex<Real> moving_vertex() const { return {vertex, x, y}; }
};

/// Not safe for several threads: each submesh has one of its own, and others read it when the
/// submesh has ended.
template <class Real>
struct DeferredQueue {
    std::vector<Deferred<Real>> entries; ///< in the order in which they were deferred
    std::size_t routed = 0;              ///< entries before this one have their route

    /// Puts off a look at the star of `v`. Amortised O(1), as are the next three.
    void star(std::uint32_t v) { put(v, DeferredKind::star); }
    /// Defers interface remeshing at `v`.
    void remeshing(std::uint32_t v) { put(v, DeferredKind::remeshing); }
    /// Leaves `v` to the interface list of the submesh that owns it now.
    void listing(std::uint32_t v) { put(v, DeferredKind::listing); }
    /// Puts off a movement.
    void moving_vertex(const MovingVertex<Real>& m) {
        entries.push_back(
            {.vertex = m.vertex, .x = m.x, .y = m.y, .kind = DeferredKind::moving_vertex});
    }
    /// Empties the queue and keeps its memory.
    void clear() {
        entries.clear();
        routed = 0;
    }

private:
    void put(std::uint32_t v, DeferredKind kind) { entries.push_back({.vertex = v, .kind = kind}); }
};

/// Where the vertices of `Work::interface` are, and where they should move; one entry for each.
template <class Real>
struct Trajectory {
    std::vector<Point<Real>> positions; ///< now
    std::vector<Point<Real>> targets;   ///< at the end of the sub-step
    std::vector<std::uint8_t> held;     ///< not 0: the velocity is not finite, the vertex stays
    IntegratorScratch<Real> scratch;    ///< `first`: the velocities
    Real dt = 0;                        ///< the time in which the targets are to be reached
};

template <class Real>
struct Pass;

/// What one submesh holds while a step runs, and a pass works on: the interface vertices that lie
/// in it, the active set (the vertices whose star changed), the log of its edits, and what it
/// leaves to another submesh. The sequential driver has one, the parallel driver one for each
/// submesh. Nothing here grows with the mesh.
template <class Real>
struct Work : Unmovable {
    /// Refers to both: the executor that owns the work keeps a copy of the options.
    Work(Complex<Real>& complex_in, const Options<Real>& options_in)
        : complex(complex_in),
          options(options_in), submesh{complex_in, Region{}, complex_in.ids, log} {}

    Complex<Real>& complex;       ///< the complex that is worked on
    const Options<Real>& options; ///< those of the simulation
    EditLog log;                  ///< the edits made here
    Submesh<Real> submesh;        ///< notes in `log`

    std::vector<std::uint32_t> interface; ///< interface vertices, roughly in the order of the curve
    Trajectory<Real> trajectory;          ///< of the interface vertices
    std::vector<MovingVertex<Real>> moving_vertices; ///< they have yet to reach their targets
    /// Stars that the interface remeshing has left as they are, in the order of `interface`:
    /// movement need not walk round them again. Of no use once a pass of motion has been run.
    std::vector<CachedStar> stars;
    std::vector<std::uint32_t> active; ///< vertices whose star must be looked at; no duplicates
    std::uint32_t epoch = 0;           ///< a vertex with this stamp is in `active` already
    /// Squared quality at or below which the mesh update lists a star in `poor`; -1: in no case.
    double watched_quality = -1;
    /// Vertices in whose stars the mesh update has left triangles that are so poor, or that it has
    /// not examined after their last edit; with duplicates.
    std::vector<std::uint32_t> poor;
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

    /// The executor's passes of remeshing: those with a `watch` are shown stars by the first one.
    std::span<const Pass<Real>> remeshing;

    std::size_t progressed =
        0;                   ///< moving vertices that came nearer to their targets in the last pass
    std::size_t arrived = 0; ///< how many of these reached them

    // Scratch, kept so that nothing is allocated from step to step.
    Star<Real> star;                           ///< the star under examination
    Star<Real> other_star;                     ///< and a second one
    std::vector<Corner> candidates;            ///< edges to be tested for the Delaunay condition
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

/// The interface, the active set and what else waits for the next step; everything else of a work
/// is scratch, or empty between two steps. To be called after the complex has been read: throws
/// FileError for an id that it does not have.
template <class Real>
void archive(Archive& archive, Work<Real>& work) {
    archive(work.interface, work.active, work.resized, work.epoch, work.time, work.dt);
    for (const auto* list : {&work.interface, &work.active, &work.resized}) {
        expect_vertices<Real>(archive, work.complex, *list);
    }
    for (const std::uint32_t v : work.interface) {
        archive.expect(work.complex.is_alive(Vertex{v}), "lists a vertex that does not live");
    }
}

/// Shown each star of an interface vertex that the interface remeshing has gathered, that the
/// submesh owns as a whole, and that is left as it is: a pass need not gather it again then. The
/// centre of a star that changes later in the remeshing is in the active set. Must not edit the
/// complex.
template <class Real>
using StarWatch =
    std::function<void(Work<Real>& work, const Star<Real>& star, const IncidentEdges& incident)>;

/// One pass over the work of one submesh: candidates, guard, edit. It edits with the operations of
/// lib/dsc/operations and `work.submesh`, which refuse what the submesh does not own, and it must
/// not keep state between calls. Later passes visit the vertices whose stars it changed, and the
/// list of the interface is brought up to date: both are read from the log of its edits.
template <class Real>
struct Pass {
    std::string name;                     ///< a few words, for lists of the passes
    std::function<void(Work<Real>&)> run; ///< does the work of one submesh
    /// True for a pass that keeps the active set and the interface list up to date itself, with the
    /// functions of edits.h; its log is then not read.
    bool attends = false;
    /// Of a pass that comes after the interface remeshing.
    StarWatch<Real> watch = {};
};

/// The passes of a step, in their order.
template <class Real>
struct Algorithm {
    std::vector<Pass<Real>> remeshing; ///< once a sub-step, before anything moves
    std::vector<Pass<Real>> motion;    ///< repeated until all vertices have arrived
};

// --- the passes of the default ------------------------------------------------------------------

/// Interface remeshing (algorithm 5.1 of the thesis, lines 6 and 7), with all vertices at the same
/// time level, before anything moves. Splits interface edges that are too long, with the
/// interpolator of the options; collapses interface vertices at short edges if the curve stays in
/// place. Rewrites `work.interface`; if a submesh may not do what is needed, the vertex stays in
/// the list and is deferred as well. O(interface vertices of the submesh).
template <class Real>
void remesh_interface(Work<Real>& work);

/// Movement (line 5): moves every moving vertex once, as far as possible. Those that arrive leave
/// `work.moving_vertices`; all that moved activate their star. O(moving vertices).
template <class Real>
void move_vertices(Work<Real>& work);

/// The mesh update (lines 9 to 20; algorithm 5.2) on the active set: only vertices whose star
/// changed are visited. For each: Delaunay flips of its incident edges, then coarsening by
/// collapse, smoothing or refinement, whichever the thresholds of its phase require. Empties
/// `work.active`; stars that a submesh may not touch are deferred. O(active).
template <class Real>
void update_mesh(Work<Real>& work);

/// The default: interface remeshing; movement, then the mesh update on the active set.
template <class Real>
Algorithm<Real> default_algorithm() {
    Algorithm<Real> algorithm;
    algorithm.remeshing.push_back({"interface remeshing", &remesh_interface<Real>, true});
    algorithm.motion.push_back({"movement", &move_vertices<Real>, true});
    algorithm.motion.push_back({"mesh update", &update_mesh<Real>, true});
    return algorithm;
}

} // namespace dsc
