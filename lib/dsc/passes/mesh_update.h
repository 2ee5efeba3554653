// SPDX-License-Identifier: MIT
// The mesh update (algorithm 5.1, lines 9 to 20; algorithm 5.2) on the active set: only vertices
// whose star changed are looked at. For each: Delaunay flips of its spokes, then coarsening by
// collapse, smoothing or refinement, whichever its phase's thresholds ask for.
#pragma once

#include "dsc/passes/work.h"

namespace dsc {

/// Works through `work.active` and empties it; what a submesh may not touch goes to
/// `put_off_active`. O(active).
template <class Real>
void update_mesh(Work<Real>& work);

} // namespace dsc
