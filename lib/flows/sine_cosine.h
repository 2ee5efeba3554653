// SPDX-License-Identifier: MIT
// sin(pi x) and cos(pi x) for many arguments at once: the swirl (thesis, section 9.6, equation 11)
// needs both of them, twice for each vertex, four times a step.
#pragma once

#include <cstddef>

namespace dsc::scenes {

/// Writes sin(pi x[i]) and cos(pi x[i]) for i < count; the arrays must not overlap. The error is
/// below 4e-16 for |x| < 1e15, and multiples of one half give exact values; beyond that, and for
/// arguments that are not finite, the result is meaningless or NaN. The result is bitwise identical
/// on every instruction set.
void sine_cosine_pi(const double* x, std::size_t count, double* sine, double* cosine);

} // namespace dsc::scenes
