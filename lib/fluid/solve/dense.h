// SPDX-License-Identifier: MIT
// L D L' of a dense symmetric matrix, as far as its first columns: the inner loops of `factors.h`.
#pragma once

#include <cstddef>

namespace dsc {

/// Eliminates the first `count` unknowns of a symmetric matrix of `height` rows. `lower` has its
/// first columns, each with all rows, and becomes L (above and on the diagonal it is not defined);
/// `left` has the lower triangle of the others, each column with `height - count` rows, and becomes
/// what remains of them. False if a pivot is zero or not finite. The same bits on any processor.
bool eliminate(std::size_t count, std::size_t height, double* lower, double* pivots, double* left);

/// Solves with L: the first `count` of the values, and what they take from the others.
void substitute_forward(std::size_t count, std::size_t height, const double* lower, double* values);

/// Solves with D and L', where the values after `count` are known.
void substitute_backward(std::size_t count, std::size_t height, const double* lower,
                         const double* pivots, double* values);

} // namespace dsc
