// SPDX-License-Identifier: MIT
// A graph of formulas as a list of operations, each with the rows that it reads and writes.
#pragma once

#include "scenes/file/formula/graph.h"

#include <vector>

namespace dsc::scenes {

/// Rows at once; one of them is read again and again, so all of them should stay in the cache.
inline constexpr int most_formula_rows = 64;
/// Operations of the two formulas together.
inline constexpr int most_formula_nodes = 512;

/// One operation on rows, by their numbers; -1 where it has none.
struct FormulaStep {
    FormulaOp op{};
    std::array<int, 3> of{-1, -1, -1};
    int result = -1;
    int second_result = -1;
};

/// A row that holds the same number for all positions.
struct FormulaFill {
    int row;
    int number; ///< index among the results of `once`
};

struct FormulaProgram {
    /// What depends on the time alone, as steps on single numbers: the results of node i are the
    /// numbers 2 i and 2 i + 1.
    std::vector<FormulaStep> once;
    std::vector<double> numbers; ///< before `once`: the constants
    int time = -1;               ///< the number that is the time; -1: unused
    std::vector<FormulaFill> fills;
    std::vector<FormulaStep> steps; ///< for each block of positions
    int x = -1;                     ///< the rows of the coordinates; -1: unused
    int y = -1;
    int u = -1; ///< the rows of the results
    int v = -1;
    int rows = 0; ///< in use
};

/// Rows are used again as soon as nobody needs them. Throws InputError, naming `where`, if the
/// formulas need too many operations or rows.
[[nodiscard]] FormulaProgram compile(const FormulaGraph& graph, FormulaNodeId u, FormulaNodeId v,
                                     const std::string& where);

} // namespace dsc::scenes
