// SPDX-License-Identifier: MIT
// The text of a formula becomes a graph.
//
//     formula    = comparison [ "?" formula ":" formula ]
//     comparison = sum [ ( "<" | "<=" | ">" | ">=" | "==" | "!=" ) sum ]
//     sum        = product { ( "+" | "-" ) product }
//     product    = signed { ( "*" | "/" ) signed }
//     signed     = { "+" | "-" } power
//     power      = operand [ "^" signed ]
//     operand    = number | name | function "(" formula { "," formula } ")" | "(" formula ")"
#pragma once

#include "scenes/file/formula/graph.h"

#include <map>
#include <string>
#include <string_view>

namespace dsc::scenes {

/// Names and their values; pi is always known.
using FormulaParameters = std::map<std::string, double, std::less<>>;

inline constexpr std::size_t longest_formula = 4096; ///< characters
inline constexpr int deepest_formula = 64;           ///< parentheses within each other
/// Operations of the two formulas together.
inline constexpr std::size_t most_formula_nodes = 512;

/// Throws InputError, with the character at which the formula breaks off and what could stand
/// there; `where` says whose formula it is. O(n^2).
[[nodiscard]] FormulaNodeId parse_formula(std::string_view text, const FormulaParameters& known,
                                          const std::string& where, FormulaGraph& graph);

/// True for a name that a parameter may have: letters, digits and _, with a letter first, and not
/// that of a variable or a function.
[[nodiscard]] bool is_parameter_name(std::string_view name);

} // namespace dsc::scenes
