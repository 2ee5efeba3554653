// SPDX-License-Identifier: MIT
#include "scenes/file/formula/graph.h"

#include "flows/sine_cosine.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace dsc::scenes {

namespace {

/// Powers with whole exponents up to this one are computed as products.
constexpr double largest_product = 8;

constexpr int any_number = 64;

// Applies a function of one or two numbers to rows. Two rows are either identical or do not
// overlap.
template <class Function>
constexpr RowOperation on_rows(Function) {
    return [](const double* a, const double* b, const double*, double* result, std::size_t count) {
#pragma omp simd
        for (std::size_t i = 0; i < count; ++i) {
            if constexpr (std::is_invocable_v<Function, double, double>) {
                result[i] = Function{}(a[i], b[i]);
            } else {
                result[i] = Function{}(a[i]);
            }
        }
    };
}

constexpr double truth(bool value) { return value ? 1.0 : 0.0; }

constexpr RowOperation multiply = on_rows([](double a, double b) { return a * b; });
constexpr RowOperation divide = on_rows([](double a, double b) { return a / b; });
constexpr RowOperation sine = on_rows([](double a) { return std::sin(a); });
constexpr RowOperation cosine = on_rows([](double a) { return std::cos(a); });

constexpr std::array comparisons{
    NamedOperation{"<=", on_rows([](double a, double b) { return truth(a <= b); })},
    NamedOperation{"<", on_rows([](double a, double b) { return truth(a < b); })},
    NamedOperation{">=", on_rows([](double a, double b) { return truth(a >= b); })},
    NamedOperation{">", on_rows([](double a, double b) { return truth(a > b); })},
    NamedOperation{"==", on_rows([](double a, double b) { return truth(a == b); })},
    NamedOperation{"!=", on_rows([](double a, double b) { return truth(a != b); })},
};
constexpr std::array sums{
    NamedOperation{"+", on_rows([](double a, double b) { return a + b; })},
    NamedOperation{"-", on_rows([](double a, double b) { return a - b; })},
};
constexpr std::array products{NamedOperation{"*", multiply}, NamedOperation{"/", divide}};

// min and max return NaN if an argument is NaN, so that it is noticed.
constexpr std::array functions{
    NamedOperation{"abs", on_rows([](double a) { return std::abs(a); }), 1, 1},
    NamedOperation{"acos", on_rows([](double a) { return std::acos(a); }), 1, 1},
    NamedOperation{"asin", on_rows([](double a) { return std::asin(a); }), 1, 1},
    NamedOperation{"atan", on_rows([](double a) { return std::atan(a); }), 1, 1},
    NamedOperation{"atan2", on_rows([](double a, double b) { return std::atan2(a, b); })},
    NamedOperation{"cos", cosine, 1, 1},
    NamedOperation{"cosh", on_rows([](double a) { return std::cosh(a); }), 1, 1},
    NamedOperation{"exp", on_rows([](double a) { return std::exp(a); }), 1, 1},
    NamedOperation{"floor", on_rows([](double a) { return std::floor(a); }), 1, 1},
    NamedOperation{"ln", on_rows([](double a) { return std::log(a); }), 1, 1},
    NamedOperation{"log", on_rows([](double a) { return std::log(a); }), 1, 1},
    NamedOperation{"log10", on_rows([](double a) { return std::log10(a); }), 1, 1},
    NamedOperation{"max",
                   on_rows([](double a, double b) { return a > b || std::isnan(a) ? a : b; }), 2,
                   any_number},
    NamedOperation{"min",
                   on_rows([](double a, double b) { return a < b || std::isnan(a) ? a : b; }), 2,
                   any_number},
    NamedOperation{"sign", on_rows([](double a) { return a > 0   ? 1.0
                                                         : a < 0 ? -1.0
                                                                 : a; }), 1, 1},
    NamedOperation{"sin", sine, 1, 1},
    NamedOperation{"sinh", on_rows([](double a) { return std::sinh(a); }), 1, 1},
    NamedOperation{"sqrt", on_rows([](double a) { return std::sqrt(a); }), 1, 1},
    NamedOperation{"tan", on_rows([](double a) { return std::tan(a); }), 1, 1},
    NamedOperation{"tanh", on_rows([](double a) { return std::tanh(a); }), 1, 1},
};

/// The sine of pi a, and its cosine in the row after the result.
constexpr RowOperation sine_cosine_pi_rows = [](const double* a, const double*, const double*,
                                                double* result, std::size_t count) {
    sine_cosine_pi(a, count, result, result + formula_row_length);
};

} // namespace

const RowOperation negate_rows = on_rows([](double a) { return -a; });
const RowOperation power_rows = on_rows([](double a, double b) { return std::pow(a, b); });
const RowOperation choose_rows = [](const double* a, const double* b, const double* c,
                                    double* result, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        result[i] = a[i] != 0 ? b[i] : c[i];
    }
};

std::span<const NamedOperation> formula_functions() { return functions; }

std::span<const NamedOperation> formula_operators(int level) {
    if (level == 0) {
        return comparisons;
    }
    return level == 1 ? std::span<const NamedOperation>(sums) : products;
}

// Compares the bits of values: 0 and -0 are different constants.
bool operator==(const FormulaNode& a, const FormulaNode& b) {
    return a.operation == b.operation && a.of == b.of && a.sees_place == b.sees_place &&
           a.sees_time == b.sees_time &&
           std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
}

FormulaGraph::FormulaGraph(int dimension)
    : nodes_{{.of = {x}, .sees_place = true},
             {.of = {y}, .sees_place = true},
             {.of = {t}, .sees_time = true}},
      dimension_(dimension) {
    if (dimension == 3) {
        nodes_.push_back({.of = {z}, .sees_place = true});
    }
}

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
    if (operation == sine || operation == cosine) {
        return sine_or_cosine(operation, a);
    }
    const bool changes_nothing = operation == multiply && is_constant(a) && at(a).value == 1;
    return changes_nothing ? b : add(node);
}

FormulaNodeId FormulaGraph::power(FormulaNodeId base, FormulaNodeId exponent) {
    const double n = at(exponent).value;
    if (!(n >= 1 && n <= largest_product && n == std::floor(n))) {
        return add(node_of(power_rows, base, exponent, no_formula_node));
    }
    FormulaNodeId product = base;
    for (int i = 1; i < static_cast<int>(n); ++i) {
        product = apply(multiply, product, base);
    }
    return product;
}

// Sine and cosine are consecutive nodes; the node of the sine computes both.
FormulaNodeId FormulaGraph::sine_or_cosine(RowOperation operation, FormulaNodeId angle) {
    const FormulaNodeId half = half_turns(angle);
    const FormulaNodeId first =
        add(node_of(sine_cosine_pi_rows, half, no_formula_node, no_formula_node));
    const FormulaNodeId second = add(node_of(nullptr, first, no_formula_node, no_formula_node));
    return operation == sine ? first : second;
}

// Divides an angle by pi: the constant factor of a product, a quotient or a negation is divided.
FormulaNodeId FormulaGraph::half_turns(FormulaNodeId angle) {
    double factor = 1;
    while (true) {
        const FormulaNode& node = at(angle);
        const auto [a, b, unused] = node.of;
        if (node.operation == negate_rows) {
            factor = -factor;
            angle = a;
        } else if (node.operation == multiply && is_constant(a)) {
            factor *= at(a).value;
            angle = b;
        } else if (node.operation == multiply && is_constant(b)) {
            factor *= at(b).value;
            angle = a;
        } else if (node.operation == divide && is_constant(b)) {
            factor /= at(b).value;
            angle = a;
        } else {
            return apply(multiply, constant(factor / std::numbers::pi), angle);
        }
    }
}

} // namespace dsc::scenes
