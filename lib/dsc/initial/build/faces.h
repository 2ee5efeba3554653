// SPDX-License-Identifier: MIT
// Phases from curves: each face of the network gets the phase that the curves around it name.
#pragma once

#include "dsc/initial/build/chains.h"
#include "dsc/initial/input/curve_check.h"

#include <span>

namespace dsc::initial {

/// Floods each face from the pieces around it. All marks must be 0, and are so afterwards. Throws
/// InputError if two curves name different phases for one face. O(triangles).
template <class Real>
void fill_faces(Complex<Real>& complex, std::span<const CheckedCurve> curves, const Chains& chains);

} // namespace dsc::initial
