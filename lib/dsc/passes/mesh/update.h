// SPDX-License-Identifier: MIT
// The mesh update (thesis, algorithm 5.1, lines 9 to 20; algorithm 5.2) on the active set: only
// vertices whose star changed are visited. For each: Delaunay flips of its spokes, then coarsening
// by collapse, smoothing or refinement, whichever the thresholds of its phase require.
#pragma once

#include "dsc/passes/work.h"

namespace dsc {

/// Works through `work.active` and empties it; stars that a submesh may not touch are deferred.
/// O(active).
template <class Real>
void update_mesh(Work<Real>& work);

} // namespace dsc
