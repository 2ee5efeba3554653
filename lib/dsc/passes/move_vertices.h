// SPDX-License-Identifier: MIT
// Movement (thesis, algorithm 5.1, line 5) of the vertices that have not reached their targets.
#pragma once

#include "dsc/passes/work.h"

namespace dsc {

/// Moves every mover once, as far as possible. Those that arrive leave `work.movers`; all that
/// moved activate their star. O(movers).
template <class Real>
void move_vertices(Work<Real>& work);

} // namespace dsc
