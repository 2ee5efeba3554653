// SPDX-License-Identifier: MIT
// The vertices of the interface, derived from the phases [8.6], and which of them are corners.
#pragma once

#include "dsc/complex/complex.h"

#include <vector>

namespace dsc {

/// Another order where `seed` is not 0, the same for the same seed. O(list).
void shuffle_interface(std::vector<std::uint32_t>& list, std::uint64_t seed);

/// All interface vertices of a complex, curve by curve; shuffled where `seed` is not 0, to see how
/// far results depend on the order of operations. O(n), once at the start.
template <class Real>
std::vector<std::uint32_t> collect_interface(const Complex<Real>& complex, std::uint64_t seed = 0);

/// Puts a list of interface vertices into the order of the curve again, from its first vertex on.
/// O(list). Uses the stamps, of which `epoch` and epoch + 1 must not be in use.
template <class Real>
void order_interface(Complex<Real>& complex, std::vector<std::uint32_t>& list, std::uint32_t epoch);

/// Marks those interface vertices of `list` as corners at which the curve turns by more than
/// `degrees`. What is marked stays marked: a corner that a flow opens is one still, and a tip that
/// has become sharp is none. O(list).
template <class Real>
void mark_corners(Complex<Real>& complex, const std::vector<std::uint32_t>& list, double degrees);

} // namespace dsc
