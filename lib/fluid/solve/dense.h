// SPDX-License-Identifier: MIT
// Partial L D L' factorisation of a dense symmetric matrix, for its first columns: the inner loops
// of `factors.h`.
#pragma once

#include <cstddef>

namespace dsc {

/// Eliminates the first `count` unknowns of a symmetric matrix of `height` rows. `lower` has the
/// first columns, each with all rows, and becomes L (undefined above and on the diagonal); `left`
/// has the lower triangle of the other columns, each with `height - count` rows, and becomes the
/// Schur complement. Returns false if a pivot is zero or not finite. Bitwise identical on any
/// processor.
bool eliminate(std::size_t count, std::size_t height, double* lower, double* pivots, double* left);

/// Solves with L for the first `count` values, and subtracts their contribution from the others.
void substitute_forward(std::size_t count, std::size_t height, const double* lower, double* values);

/// Solves with D and L'; the values after the first `count` are already known.
void substitute_backward(std::size_t count, std::size_t height, const double* lower,
                         const double* pivots, double* values);

} // namespace dsc
