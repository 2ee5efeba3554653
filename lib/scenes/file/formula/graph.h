// SPDX-License-Identifier: MIT
// Formulas as a graph of operations in which nothing is written twice: what two formulas have in
// common, or one formula says again, is one node and is computed once.
#pragma once

#include "scenes/file/formula/operations.h"

#include <array>
#include <map>
#include <tuple>
#include <vector>

namespace dsc::scenes {

/// A node of the graph, by its index.
using FormulaNodeId = int;
inline constexpr FormulaNodeId no_formula_node = -1;

struct FormulaNode {
    FormulaOp op = FormulaOp::constant;
    /// The operands, which come before this node.
    std::array<FormulaNodeId, 3> of{no_formula_node, no_formula_node, no_formula_node};
    double value = 0;    ///< of a constant
    bool varies = false; ///< depends on x or y, not on the time alone
};

class FormulaGraph {
public:
    [[nodiscard]] FormulaNodeId constant(double value);
    /// x, y or t.
    [[nodiscard]] FormulaNodeId variable(FormulaOp op);
    /// The node of this operation: a new one, an equal one that is there already, or a constant if
    /// all operands are. Small whole powers become products. A constant factor of the argument of
    /// a sine or cosine is divided by pi once and for all, so that sin(pi x) is exact where x is a
    /// multiple of one half.
    [[nodiscard]] FormulaNodeId apply(FormulaOp op, FormulaNodeId a,
                                      FormulaNodeId b = no_formula_node,
                                      FormulaNodeId c = no_formula_node);

    [[nodiscard]] const std::vector<FormulaNode>& nodes() const { return nodes_; }

private:
    struct Scaled {
        double factor;
        FormulaNodeId node;
    };

    [[nodiscard]] const FormulaNode& at(FormulaNodeId id) const {
        return nodes_[static_cast<std::size_t>(id)];
    }
    [[nodiscard]] bool is_constant(FormulaNodeId id) const {
        return at(id).op == FormulaOp::constant;
    }
    FormulaNodeId add(const FormulaNode& node);
    FormulaNodeId folded(FormulaOp op, FormulaNodeId a, FormulaNodeId b, FormulaNodeId c);
    FormulaNodeId power(FormulaNodeId base, FormulaNodeId exponent);
    FormulaNodeId sine_or_cosine(FormulaOp op, FormulaNodeId argument);
    FormulaNodeId sine_or_cosine_pi(FormulaOp op, FormulaNodeId half_turns);
    [[nodiscard]] Scaled without_factor(FormulaNodeId id) const;

    using Identity = std::tuple<FormulaOp, std::array<FormulaNodeId, 3>, std::uint64_t>;
    std::vector<FormulaNode> nodes_;
    std::map<Identity, FormulaNodeId> known_;
};

} // namespace dsc::scenes
