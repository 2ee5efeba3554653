// SPDX-License-Identifier: MIT
// Algorithm 5.1 of the thesis as a list of passes. An application replaces, removes or adds passes
// without touching the drivers; both drivers run the same list, on the whole complex or on each
// submesh.
#pragma once

#include "dsc/passes/work.h"

#include <functional>
#include <string>
#include <vector>

namespace dsc {

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
};

/// The passes of a step, in their order.
template <class Real>
struct Algorithm {
    std::vector<Pass<Real>> upkeep; ///< once a sub-step, before anything moves
    std::vector<Pass<Real>> motion; ///< repeated until all vertices have arrived
};

/// The default: interface upkeep; movement, then the mesh update on the active set.
template <class Real>
Algorithm<Real> default_algorithm();

// --- the passes of the default ------------------------------------------------------------------

/// Interface upkeep (algorithm 5.1 of the thesis, lines 6 and 7), with all vertices at the same
/// time level, before anything moves. Splits interface edges that are too long, with the
/// interpolator of the options; collapses interface vertices at short edges if the curve stays in
/// place. Rewrites `work.interface`; if a submesh may not do what is needed, the vertex stays in
/// the list and is deferred as well. O(interface vertices of the submesh).
template <class Real>
void upkeep_interface(Work<Real>& work);

/// Movement (line 5): moves every mover once, as far as possible. Those that arrive leave
/// `work.movers`; all that moved activate their star. O(movers).
template <class Real>
void move_vertices(Work<Real>& work);

/// The mesh update (lines 9 to 20; algorithm 5.2) on the active set: only vertices whose star
/// changed are visited. For each: Delaunay flips of its spokes, then coarsening by collapse,
/// smoothing or refinement, whichever the thresholds of its phase require. Empties `work.active`;
/// stars that a submesh may not touch are deferred. O(active).
template <class Real>
void update_mesh(Work<Real>& work);

} // namespace dsc
