// SPDX-License-Identifier: MIT
// Phases from the interface: each region gets the phase that the paths around it name.
#pragma once

#include "dsc/initial/build/chains.h"
#include "dsc/initial/input/input_check.h"

#include <span>

namespace dsc::initial {

/// Floods each region from the pieces around it; a region that no path names keeps its phase. All
/// marks must be 0, and are so afterwards. Throws InputError if two paths name different phases for
/// one region, or one has the same phase on both sides. O(triangles).
template <class Real>
void fill_phases(Complex<Real>& complex, std::span<const CheckedPath> paths, const Chains& chains);

} // namespace dsc::initial
