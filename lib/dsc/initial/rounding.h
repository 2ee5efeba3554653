// SPDX-License-Identifier: MIT
// Rounding of doubles to the scalar of a complex.
#pragma once

#include "dsc/base/types.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsc::initial {

/// The nearest representable number. Rounds through memory, because g++ 12 at -O2 removes two
/// conversions from double to float and back that are side by side in a vector register.
template <class Real>
Real narrowed(double value) {
    const volatile Real narrow = static_cast<Real>(value);
    return narrow;
}

template <class Real>
Point<Real> narrowed(const Point<double>& point) {
    return {narrowed<Real>(point.x()), narrowed<Real>(point.y())};
}

/// The larger magnitude of the two coordinates.
inline double largest(const Point<double>& point) {
    return std::max(std::abs(point.x()), std::abs(point.y()));
}

/// The nearest representable point; a coordinate beyond the range of the scalar becomes infinite.
template <class Real>
Point<double> rounded(const Point<double>& point) {
    constexpr auto limit = static_cast<double>(std::numeric_limits<Real>::max());
    if (largest(point) > limit) {
        return Point<double>::Constant(std::numeric_limits<double>::infinity());
    }
    return narrowed<Real>(point).template cast<double>();
}

} // namespace dsc::initial
