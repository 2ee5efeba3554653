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

} // namespace dsc
