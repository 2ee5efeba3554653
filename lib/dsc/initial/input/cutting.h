// SPDX-License-Identifier: MIT
// Edges of the interface that are longer than the target are cut into equal pieces.
#pragma once

#include "dsc/initial/rounding.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dsc::initial {

/// A length that is a whole number of target lengths, up to rounding, is cut into as many pieces.
inline constexpr double whole_number_slack = 1e-9;

inline double piece_count(const Point<double>& a, const Point<double>& b, double edge_length) {
    return std::max(1.0, std::ceil((b - a).norm() / edge_length * (1 - whole_number_slack)));
}

/// Point k of the edge from a to b cut into so many pieces, rounded to the scalar; a itself for 0.
template <class Real>
Point<double> cut_point(const Point<double>& a, const Point<double>& b, std::uint32_t k,
                        std::uint32_t pieces) {
    const double fraction = static_cast<double>(k) / pieces;
    return k == 0 ? a : rounded<Real>(a + fraction * (b - a));
}

} // namespace dsc::initial
