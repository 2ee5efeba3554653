// SPDX-License-Identifier: MIT
// Interface upkeep: coarsening and refinement of the interface (algorithm 5.1, lines 6 and 7), with
// all vertices at the same time level, before anything moves.
#pragma once

#include "dsc/algorithm/work.h"

namespace dsc {

/// Splits interface edges that are too long, by the interpolator of the options; collapses
/// interface vertices at short edges where the curve stays where it is. Rewrites `work.interface`;
/// where a submesh may not do what is needed, the vertex stays in the list and goes to
/// `put_off_interface` as well.
/// O(interface vertices of the submesh).
template <class Real>
void upkeep_interface(Work<Real>& work);

/// All interface vertices of a complex, curve by curve; shuffled where `seed` is not 0, to see how
/// far results depend on the order of operations. O(n), once at the start.
template <class Real>
std::vector<std::uint32_t> collect_interface(const Complex<Real>& complex, std::uint64_t seed = 0);

/// Puts a list of interface vertices into the order of the curve again, from its first vertex on.
/// O(list). Uses the stamps, of which `epoch` and epoch + 1 must not be in use.
template <class Real>
void order_interface(Complex<Real>& complex, std::vector<std::uint32_t>& list, std::uint32_t epoch);

} // namespace dsc
