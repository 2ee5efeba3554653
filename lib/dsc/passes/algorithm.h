// SPDX-License-Identifier: MIT
// Algorithm 5.1 of the thesis as a list of passes. An application may replace, remove or add passes
// without changing the drivers; both drivers run the same list: on the whole complex, or on each
// submesh.
#pragma once

#include "dsc/passes/work.h"

#include <functional>
#include <string>
#include <vector>

namespace dsc {

/// Called with each star of an interface vertex that the interface remeshing has gathered and not
/// changed, and that the submesh owns as a whole, so that a later pass need not gather it again.
/// The centre of a star that changes later in the remeshing is in the active set. Must not edit the
/// complex.
template <class Real>
using StarWatch =
    std::function<void(Work<Real>& work, const Star<Real>& star, const IncidentEdges& incident)>;

/// One pass over the work of one submesh: candidates, guard, edit. It edits with the operations of
/// lib/dsc/operations and `work.submesh`, which refuse what the submesh does not own, and it must
/// not keep state between calls. The log of its edits is read afterwards: later passes visit the
/// vertices whose stars changed, and the list of the interface is updated.
template <class Real>
struct Pass {
    std::string name;                     ///< the name, in a few words, for lists of passes
    std::function<void(Work<Real>&)> run; ///< processes one submesh
    /// True for a pass that keeps the active set and the interface list up to date itself, with the
    /// functions of edits.h; its log is then not read.
    bool attends = false;
    /// Only for passes that come after the interface remeshing.
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
/// place. Rewrites `work.interface`; if the submesh may not make a necessary edit, the vertex stays
/// in the list and is deferred as well. O(interface vertices of the submesh).
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
