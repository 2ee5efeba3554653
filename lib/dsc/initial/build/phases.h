// SPDX-License-Identifier: MIT
// Phases from the interface: each region gets the phase that the paths around it name.
#pragma once

#include "dsc/initial/build/interface.h"
#include "dsc/initial/input/input_check.h"

#include <span>

namespace dsc::initial {

/// Gives each region between the paths the phase that these name; one that none names keeps its
/// phase. All marks must be 0, and are so afterwards. Throws InputError if two paths name different
/// phases for one region, or one has the same phase on both sides. O(triangles).
template <class Real>
void fill_phases(Complex<Real>& complex, std::span<const CheckedPath> paths, const Chains& chains);

} // namespace dsc::initial
