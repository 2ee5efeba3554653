// SPDX-License-Identifier: MIT
#include "scenes/file/formula/graph.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

/// Up to this exponent, a power is a product.
constexpr double largest_product = 8;

} // namespace

// By the bits of the value: 0 and -0 are different constants.
bool operator==(const FormulaNode& a, const FormulaNode& b) {
    return a.operation == b.operation && a.of == b.of && a.sees_place == b.sees_place &&
           a.sees_time == b.sees_time &&
           std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
}

FormulaGraph::FormulaGraph()
    : nodes_{{.of = {x}, .sees_place = true},
             {.of = {y}, .sees_place = true},
             {.of = {t}, .sees_time = true}} {}

FormulaNodeId FormulaGraph::add(const FormulaNode& node) {
    const auto found = std::ranges::find(nodes_, node);
    const auto id = static_cast<FormulaNodeId>(found - nodes_.begin());
    if (found == nodes_.end()) {
        nodes_.push_back(node);
    }
    return id;
}

FormulaNodeId FormulaGraph::constant(double value) { return add({.value = value}); }

FormulaNode FormulaGraph::node_of(RowOperation operation, FormulaNodeId a, FormulaNodeId b,
                                  FormulaNodeId c) const {
    FormulaNode node{.operation = operation, .of = {a, b, c}};
    for (const FormulaNodeId operand : node.of) {
        if (operand != no_formula_node) {
            node.sees_place = node.sees_place || at(operand).sees_place;
            node.sees_time = node.sees_time || at(operand).sees_time;
        }
    }
    return node;
}

FormulaNodeId FormulaGraph::apply(RowOperation operation, FormulaNodeId a, FormulaNodeId b,
                                  FormulaNodeId c) {
    const FormulaNode node = node_of(operation, a, b, c);
    if (!node.sees_place && !node.sees_time) {
        const auto value = [&](FormulaNodeId id) { return id < 0 ? nullptr : &at(id).value; };
        double result = 0;
        operation(value(a), value(b), value(c), &result, 1);
        return constant(result);
    }
    if (operation == power_rows && is_constant(b)) {
        return power(a, b);
    }
    if (operation == sine_rows || operation == cosine_rows) {
        return sine_or_cosine(operation, a);
    }
    const bool changes_nothing = operation == multiply_rows && is_constant(a) && at(a).value == 1;
    return changes_nothing ? b : add(node);
}

FormulaNodeId FormulaGraph::power(FormulaNodeId base, FormulaNodeId exponent) {
    const double n = at(exponent).value;
    if (!(n >= 1 && n <= largest_product && n == std::floor(n))) {
        return add(node_of(power_rows, base, exponent, no_formula_node));
    }
    FormulaNodeId product = base;
    for (int i = 1; i < static_cast<int>(n); ++i) {
        product = apply(multiply_rows, product, base);
    }
    return product;
}

// The two stand side by side; the node of the sine computes both.
FormulaNodeId FormulaGraph::sine_or_cosine(RowOperation operation, FormulaNodeId angle) {
    const FormulaNodeId half = half_turns(angle);
    const FormulaNodeId first =
        add(node_of(sine_cosine_pi_rows, half, no_formula_node, no_formula_node));
    const FormulaNodeId second = add(node_of(nullptr, first, no_formula_node, no_formula_node));
    return operation == sine_rows ? first : second;
}

// The constant factors of a product, a quotient or a negative are taken out and divided by pi.
FormulaNodeId FormulaGraph::half_turns(FormulaNodeId angle) {
    double factor = 1;
    while (true) {
        const FormulaNode& node = at(angle);
        const auto [a, b, unused] = node.of;
        if (node.operation == negate_rows) {
            factor = -factor;
            angle = a;
        } else if (node.operation == multiply_rows && is_constant(a)) {
            factor *= at(a).value;
            angle = b;
        } else if (node.operation == multiply_rows && is_constant(b)) {
            factor *= at(b).value;
            angle = a;
        } else if (node.operation == divide_rows && is_constant(b)) {
            factor /= at(b).value;
            angle = a;
        } else {
            return apply(multiply_rows, constant(factor / std::numbers::pi), angle);
        }
    }
}

} // namespace dsc::scenes
