// SPDX-License-Identifier: MIT
// Phases from outlines: each region between outlines is flooded from one of its edges.
#pragma once

#include "dsc/initial/build/chains.h"
#include "dsc/initial/input/input_check.h"

#include <span>

namespace dsc::initial {

/// Gives the triangles inside each outline, but outside of those that it contains, its phase. All
/// marks must be 0, and are so afterwards. O(triangles inside).
template <class Real>
void fill_phases(Complex<Real>& complex, std::span<const Outline> outlines, const Chains& chains);

} // namespace dsc::initial
