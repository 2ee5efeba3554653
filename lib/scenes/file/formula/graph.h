// SPDX-License-Identifier: MIT
// Formulas as a graph of operations. Common subexpressions, of one formula or of several, are one
// node and are computed once. Each operation acts on rows of numbers.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dsc::scenes {

/// Length of rows: with few operations, all rows fit into the first-level cache.
inline constexpr std::size_t formula_row_length = 64;

/// Computes `count` numbers element by element from the operands' rows; missing operands are null.
/// Each result depends only on its own elements.
using RowOperation = void (*)(const double* a, const double* b, const double* c, double* result,
                              std::size_t count);

/// A function, or an operator between two operands.
struct NamedOperation {
    std::string_view name;
    RowOperation operation;
    int min_arguments = 2;
    int max_arguments = 2; ///< min and max accept more, applied in pairs
};

/// All functions in alphabetical order.
[[nodiscard]] std::span<const NamedOperation> formula_functions();

inline constexpr int operator_levels = 3;
/// The operators of a level of precedence, from the lowest, 0: comparisons (1 if true, 0 if not),
/// sums and products. A name that is a prefix of another comes after it.
[[nodiscard]] std::span<const NamedOperation> formula_operators(int level);

/// Other operations of formulas.
extern const RowOperation negate_rows;
extern const RowOperation power_rows;
extern const RowOperation choose_rows; ///< b if a is not 0, else c

/// A node of the graph, by its index.
using FormulaNodeId = int;
inline constexpr FormulaNodeId no_formula_node = -1;

struct FormulaNode {
    RowOperation operation = nullptr; ///< null for x, y, t, constants, and cosines
    /// The operands, which come before this node.
    std::array<FormulaNodeId, 3> of{no_formula_node, no_formula_node, no_formula_node};
    bool sees_place = false; ///< whether it depends on x, y or z
    bool sees_time = false;
    double value = 0; ///< of a constant

    friend bool operator==(const FormulaNode& a, const FormulaNode& b);
};

class FormulaGraph {
public:
    static constexpr FormulaNodeId x = 0;
    static constexpr FormulaNodeId y = 1;
    static constexpr FormulaNodeId t = 2;
    static constexpr FormulaNodeId z = 3; ///< in three dimensions

    /// `dimension`: 2 or 3.
    explicit FormulaGraph(int dimension = 2);

    /// The names of the variables, one letter each: the first nodes.
    [[nodiscard]] std::string_view variables() const { return dimension_ == 3 ? "xytz" : "xyt"; }

    [[nodiscard]] FormulaNodeId constant(double value);
    /// The node of this operation: a new one, an existing equal one, or a constant if all operands
    /// are constants. Small whole powers become products. A constant factor of the argument of a
    /// sine or cosine is divided by pi in advance, so sin(pi x) is exact if x is a multiple of one
    /// half. O(nodes).
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
    int dimension_;
};

/// The parameters and their values; pi is always defined.
using FormulaParameters = std::map<std::string, double, std::less<>>;

/// Throws InputError with the position of the error and what is allowed there; `where` names the
/// formula. O(n^2).
[[nodiscard]] FormulaNodeId parse_formula(std::string_view text, const FormulaParameters& known,
                                          const std::string& where, FormulaGraph& graph);

} // namespace dsc::scenes
