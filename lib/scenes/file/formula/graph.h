// SPDX-License-Identifier: MIT
// Formulas as a graph of operations in which nothing is written twice: what two formulas have in
// common, or one formula says again, is one node and is computed once.
#pragma once

#include "scenes/file/formula/operations.h"

#include <array>
#include <span>
#include <vector>

namespace dsc::scenes {

/// A node of the graph, by its index.
using FormulaNodeId = int;
inline constexpr FormulaNodeId no_formula_node = -1;

struct FormulaNode {
    RowOperation operation = nullptr; ///< null for x, y, t, constants, and cosines
    /// The operands, which come before this node.
    std::array<FormulaNodeId, 3> of{no_formula_node, no_formula_node, no_formula_node};
    bool sees_place = false; ///< depends on x or y
    bool sees_time = false;
    double value = 0; ///< of a constant, which sees neither

    friend bool operator==(const FormulaNode& a, const FormulaNode& b);
};

class FormulaGraph {
public:
    static constexpr FormulaNodeId x = 0;
    static constexpr FormulaNodeId y = 1;
    static constexpr FormulaNodeId t = 2;

    FormulaGraph();

    [[nodiscard]] FormulaNodeId constant(double value);
    /// The node of this operation: a new one, an equal one that is there already, or a constant if
    /// all operands are. Small whole powers become products. A constant factor of the argument of
    /// a sine or cosine is divided by pi once and for all, so that sin(pi x) is exact where x is a
    /// multiple of one half. O(nodes).
    [[nodiscard]] FormulaNodeId apply(RowOperation operation, FormulaNodeId a,
                                      FormulaNodeId b = no_formula_node,
                                      FormulaNodeId c = no_formula_node);

    [[nodiscard]] std::span<const FormulaNode> nodes() const { return nodes_; }
    [[nodiscard]] const FormulaNode& at(FormulaNodeId id) const {
        return nodes_[static_cast<std::size_t>(id)];
    }

private:
    [[nodiscard]] bool is_constant(FormulaNodeId id) const {
        return !at(id).sees_place && !at(id).sees_time;
    }
    FormulaNodeId add(const FormulaNode& node);
    [[nodiscard]] FormulaNode node_of(RowOperation operation, FormulaNodeId a, FormulaNodeId b,
                                      FormulaNodeId c) const;
    FormulaNodeId power(FormulaNodeId base, FormulaNodeId exponent);
    FormulaNodeId sine_or_cosine(RowOperation operation, FormulaNodeId angle);
    FormulaNodeId half_turns(FormulaNodeId angle);

    std::vector<FormulaNode> nodes_;
};

} // namespace dsc::scenes
