// SPDX-License-Identifier: MIT
#include "scenes/file/formula/graph.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

using std::numbers::pi;
using Op = FormulaOp;

/// Up to this exponent, a power is a product.
constexpr double largest_product = 8;

double value_of(Op op, double a, double b, double c) {
    double result = 0;
    double second = 0;
    execute(op, {&a, &b, &c, &result, &second}, 1);
    return result;
}

} // namespace

FormulaNodeId FormulaGraph::add(const FormulaNode& node) {
    const Identity identity{node.op, node.of, std::bit_cast<std::uint64_t>(node.value)};
    const auto [found, is_new] =
        known_.try_emplace(identity, static_cast<FormulaNodeId>(nodes_.size()));
    if (is_new) {
        nodes_.push_back(node);
    }
    return found->second;
}

FormulaNodeId FormulaGraph::constant(double value) {
    return add({.op = Op::constant, .value = value});
}

FormulaNodeId FormulaGraph::variable(FormulaOp op) {
    return add({.op = op, .varies = op != Op::t});
}

FormulaNodeId FormulaGraph::apply(FormulaOp op, FormulaNodeId a, FormulaNodeId b, FormulaNodeId c) {
    switch (op) {
    case Op::power: return power(a, b);
    case Op::sine:
    case Op::cosine: return sine_or_cosine(op, a);
    case Op::add:
    case Op::multiply:
        // The order makes no difference to the result, but x y and y x shall be one node.
        return folded(op, std::min(a, b), std::max(a, b), c);
    default: return folded(op, a, b, c);
    }
}

FormulaNodeId FormulaGraph::folded(FormulaOp op, FormulaNodeId a, FormulaNodeId b,
                                   FormulaNodeId c) {
    FormulaNode node{.op = op, .of = {a, b, c}};
    bool is_fixed = true;
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < 3; ++i) {
        if (node.of[i] != no_formula_node) {
            is_fixed = is_fixed && is_constant(node.of[i]);
            values[i] = at(node.of[i]).value;
            node.varies = node.varies || at(node.of[i]).varies;
        }
    }
    if (is_fixed) {
        return constant(value_of(op, values[0], values[1], values[2]));
    }
    if (op == Op::multiply) {
        for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
            if (is_constant(one) && at(one).value == 1) {
                return other;
            }
        }
    }
    return add(node);
}

FormulaNodeId FormulaGraph::power(FormulaNodeId base, FormulaNodeId exponent) {
    if (is_constant(exponent) && !is_constant(base)) {
        const double n = at(exponent).value;
        if (n == 0.5) {
            return folded(Op::square_root, base, no_formula_node, no_formula_node);
        }
        if (n >= 1 && n <= largest_product && n == std::floor(n)) {
            FormulaNodeId product = base;
            for (int i = 1; i < static_cast<int>(n); ++i) {
                product = apply(Op::multiply, product, base);
            }
            return product;
        }
    }
    return folded(Op::power, base, exponent, no_formula_node);
}

// The constant factors of a product, a quotient or a negative are taken out.
FormulaGraph::Scaled FormulaGraph::without_factor(FormulaNodeId id) const {
    Scaled scaled{1.0, id};
    while (true) {
        const FormulaNode& node = at(scaled.node);
        if (node.op == Op::negate) {
            scaled = {-scaled.factor, node.of[0]};
        } else if (node.op == Op::multiply && is_constant(node.of[0])) {
            scaled = {scaled.factor * at(node.of[0]).value, node.of[1]};
        } else if (node.op == Op::multiply && is_constant(node.of[1])) {
            scaled = {scaled.factor * at(node.of[1]).value, node.of[0]};
        } else if (node.op == Op::divide && is_constant(node.of[1])) {
            scaled = {scaled.factor / at(node.of[1]).value, node.of[0]};
        } else {
            return scaled;
        }
    }
}

FormulaNodeId FormulaGraph::sine_or_cosine(FormulaOp op, FormulaNodeId argument) {
    if (is_constant(argument)) {
        const double value = at(argument).value;
        return constant(op == Op::sine ? std::sin(value) : std::cos(value));
    }
    const auto [factor, node] = without_factor(argument);
    const double half_turns = factor / pi;
    if (std::abs(half_turns) == 2) {
        // Where sin(2 pi x) is needed, sin(pi x) often is as well: one of them is computed.
        const FormulaNodeId s = sine_or_cosine_pi(Op::sine, node);
        const FormulaNodeId c = sine_or_cosine_pi(Op::cosine, node);
        return op == Op::sine
                   ? apply(Op::multiply, constant(half_turns), apply(Op::multiply, s, c))
                   : apply(Op::multiply, apply(Op::subtract, c, s), apply(Op::add, c, s));
    }
    return sine_or_cosine_pi(op, apply(Op::multiply, constant(half_turns), node));
}

FormulaNodeId FormulaGraph::sine_or_cosine_pi(FormulaOp op, FormulaNodeId half_turns) {
    const FormulaNodeId both =
        folded(Op::sine_cosine_pi, half_turns, no_formula_node, no_formula_node);
    return folded(op, both, no_formula_node, no_formula_node);
}

} // namespace dsc::scenes
