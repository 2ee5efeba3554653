// SPDX-License-Identifier: MIT
// Rounding of doubles to the scalar of a complex.
#pragma once

#include "dsc/base/types.h"

namespace dsc::initial {

/// The nearest representable number. Through memory: g++ 12 at -O2 turns two conversions from
/// double to float and back, side by side in a vector register, into none.
template <class Real>
Real narrowed(double value) {
    const volatile Real narrow = static_cast<Real>(value);
    return narrow;
}

template <class Real>
Point<Real> narrowed(const Point<double>& point) {
    return {narrowed<Real>(point.x()), narrowed<Real>(point.y())};
}

} // namespace dsc::initial
