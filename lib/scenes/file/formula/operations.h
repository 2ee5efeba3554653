// SPDX-License-Identifier: MIT
// What a formula can compute: its operations by their names in the text, and each of them on rows
// of numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace dsc::scenes {

enum class FormulaOp : std::uint8_t {
    constant,
    x,
    y,
    t,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    less,          ///< comparisons give 1 or 0
    less_or_equal, ///< a > b is written as b < a
    equal,
    choose,         ///< a ? b : c
    sine_cosine_pi, ///< of pi a; has two results
    sine,           ///< the first result of the node a, which is a sine_cosine_pi
    cosine,         ///< the second
    tangent,
    arc_sine,
    arc_cosine,
    arc_tangent,
    arc_tangent_2,
    hyperbolic_sine,
    hyperbolic_cosine,
    hyperbolic_tangent,
    exponential,
    logarithm,
    logarithm_10,
    square_root,
    absolute,
    sign,
    floor,
    minimum,
    maximum,
};

/// A function as it is written in a formula.
struct FormulaFunction {
    std::string_view name;
    FormulaOp op;
    int least_arguments; ///< min and max take more
    int most_arguments;
};

/// In alphabetical order.
[[nodiscard]] std::span<const FormulaFunction> formula_functions();

/// The rows that an operation reads and writes; those that it does not have are null. A result may
/// be in the place of an argument, except for sine_cosine_pi.
struct FormulaRows {
    const double* a = nullptr;
    const double* b = nullptr;
    const double* c = nullptr;
    double* result = nullptr;
    double* second_result = nullptr; ///< of sine_cosine_pi
};

/// Computes one operation on `count` numbers. The result for each does not depend on the others.
/// Not for constants, variables, and the names of a sine or cosine.
void execute(FormulaOp op, const FormulaRows& rows, std::size_t count);

} // namespace dsc::scenes
