// SPDX-License-Identifier: MIT
// Movement (algorithm 5.1, line 5) of the vertices that are on their way.
#pragma once

#include "dsc/passes/work.h"

namespace dsc {

/// Every mover as far as possible, once. Those that arrive leave
/// `work.movers`; all that moved activate their star. O(movers).
template <class Real>
void move_vertices(Work<Real>& work);

} // namespace dsc
