// SPDX-License-Identifier: MIT
// Interface upkeep: coarsening and refinement of the interface (algorithm 5.1 of the thesis, lines
// 6 and 7), with all vertices at the same time level, before anything moves.
#pragma once

#include "dsc/passes/work.h"

namespace dsc {

/// Splits interface edges that are too long, with the interpolator of the options; collapses
/// interface vertices at short edges if the curve stays in place. Rewrites `work.interface`; if a
/// submesh may not do what is needed, the vertex stays in the list and is deferred as well.
/// O(interface vertices of the submesh).
template <class Real>
void upkeep_interface(Work<Real>& work);

} // namespace dsc
