// SPDX-License-Identifier: MIT
// Interface upkeep: coarsening and refinement of the interface (algorithm 5.1, lines 6 and 7), with
// all vertices at the same time level, before anything moves.
#pragma once

#include "dsc/passes/work.h"

namespace dsc {

/// Splits interface edges that are too long, by the interpolator of the options; collapses
/// interface vertices at short edges where the curve stays where it is. Rewrites `work.interface`;
/// where a submesh may not do what is needed, the vertex stays in the list and goes to
/// `put_off_interface` as well.
/// O(interface vertices of the submesh).
template <class Real>
void upkeep_interface(Work<Real>& work);

} // namespace dsc
