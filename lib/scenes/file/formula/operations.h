// SPDX-License-Identifier: MIT
// What a formula can compute: functions by their names, operators by their signs, and each of them
// on rows of numbers.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace dsc::scenes {

/// Numbers at once: with few operations, their rows stay in the first-level cache.
inline constexpr std::size_t formula_row_length = 64;

/// Computes `count` numbers, each from those in the same place of the operands' rows; an operand
/// that an operation does not have is null. The result for one place does not depend on the others.
using RowOperation = void (*)(const double* a, const double* b, const double* c, double* result,
                              std::size_t count);

/// A function, or an operator between two operands.
struct NamedOperation {
    std::string_view name;
    RowOperation operation;
    int least_arguments = 2;
    int most_arguments = 2; ///< min and max take more, two by two
};

/// In alphabetical order.
[[nodiscard]] std::span<const NamedOperation> formula_functions();

inline constexpr int operator_levels = 3;
/// The operators of a level, from 0, which binds least: comparisons (1 if true, 0 if not), sums and
/// products. A name comes after any that it is the beginning of.
[[nodiscard]] std::span<const NamedOperation> formula_operators(int level);

/// Those that a formula needs besides, or that the graph looks for.
extern const RowOperation negate_rows;
extern const RowOperation multiply_rows;
extern const RowOperation divide_rows;
extern const RowOperation power_rows;
extern const RowOperation choose_rows; ///< b where a is not 0, and c elsewhere
extern const RowOperation sine_rows;
extern const RowOperation cosine_rows;
/// The sine of pi a, and in the row behind the result its cosine.
extern const RowOperation sine_cosine_pi_rows;

} // namespace dsc::scenes
