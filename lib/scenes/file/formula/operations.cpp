// SPDX-License-Identifier: MIT
#include "scenes/file/formula/operations.h"

#include "flows/sine_cosine.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsc::scenes {

namespace {

constexpr int any_number = 64;

constexpr std::array functions{
    FormulaFunction{"abs", FormulaOp::absolute, 1, 1},
    FormulaFunction{"acos", FormulaOp::arc_cosine, 1, 1},
    FormulaFunction{"asin", FormulaOp::arc_sine, 1, 1},
    FormulaFunction{"atan", FormulaOp::arc_tangent, 1, 1},
    FormulaFunction{"atan2", FormulaOp::arc_tangent_2, 2, 2},
    FormulaFunction{"cos", FormulaOp::cosine, 1, 1},
    FormulaFunction{"cosh", FormulaOp::hyperbolic_cosine, 1, 1},
    FormulaFunction{"exp", FormulaOp::exponential, 1, 1},
    FormulaFunction{"floor", FormulaOp::floor, 1, 1},
    FormulaFunction{"ln", FormulaOp::logarithm, 1, 1},
    FormulaFunction{"log", FormulaOp::logarithm, 1, 1},
    FormulaFunction{"log10", FormulaOp::logarithm_10, 1, 1},
    FormulaFunction{"max", FormulaOp::maximum, 2, any_number},
    FormulaFunction{"min", FormulaOp::minimum, 2, any_number},
    FormulaFunction{"sign", FormulaOp::sign, 1, 1},
    FormulaFunction{"sin", FormulaOp::sine, 1, 1},
    FormulaFunction{"sinh", FormulaOp::hyperbolic_sine, 1, 1},
    FormulaFunction{"sqrt", FormulaOp::square_root, 1, 1},
    FormulaFunction{"tan", FormulaOp::tangent, 1, 1},
    FormulaFunction{"tanh", FormulaOp::hyperbolic_tangent, 1, 1},
};

// Rows are the same or apart, never shifted against each other.
template <class Function>
void for_each_one(const FormulaRows& rows, std::size_t count, Function function) {
    const double* a = rows.a;
    double* result = rows.result;
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        result[i] = function(a[i]);
    }
}

template <class Function>
void for_each_two(const FormulaRows& rows, std::size_t count, Function function) {
    const double* a = rows.a;
    const double* b = rows.b;
    double* result = rows.result;
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) {
        result[i] = function(a[i], b[i]);
    }
}

// NaN where one of the two is, so that it is noticed.
double smaller(double a, double b) { return a < b || std::isnan(a) ? a : b; }
double larger(double a, double b) { return a > b || std::isnan(a) ? a : b; }
double sign_of(double a) { return a > 0 ? 1.0 : a < 0 ? -1.0 : a; }

void choose(const FormulaRows& rows, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        rows.result[i] = rows.a[i] != 0 ? rows.b[i] : rows.c[i];
    }
}

} // namespace

std::span<const FormulaFunction> formula_functions() { return functions; }

void execute(FormulaOp op, const FormulaRows& rows, std::size_t count) {
    using Op = FormulaOp;
    const auto one = [&](auto function) { for_each_one(rows, count, function); };
    const auto two = [&](auto function) { for_each_two(rows, count, function); };
    switch (op) {
    case Op::negate: return one([](double a) { return -a; });
    case Op::add: return two([](double a, double b) { return a + b; });
    case Op::subtract: return two([](double a, double b) { return a - b; });
    case Op::multiply: return two([](double a, double b) { return a * b; });
    case Op::divide: return two([](double a, double b) { return a / b; });
    case Op::power: return two([](double a, double b) { return std::pow(a, b); });
    case Op::less: return two([](double a, double b) { return a < b ? 1.0 : 0.0; });
    case Op::less_or_equal: return two([](double a, double b) { return a <= b ? 1.0 : 0.0; });
    case Op::equal: return two([](double a, double b) { return a == b ? 1.0 : 0.0; });
    case Op::choose: return choose(rows, count);
    case Op::sine_cosine_pi: return sine_cosine_pi(rows.a, count, rows.result, rows.second_result);
    case Op::tangent: return one([](double a) { return std::tan(a); });
    case Op::arc_sine: return one([](double a) { return std::asin(a); });
    case Op::arc_cosine: return one([](double a) { return std::acos(a); });
    case Op::arc_tangent: return one([](double a) { return std::atan(a); });
    case Op::arc_tangent_2: return two([](double a, double b) { return std::atan2(a, b); });
    case Op::hyperbolic_sine: return one([](double a) { return std::sinh(a); });
    case Op::hyperbolic_cosine: return one([](double a) { return std::cosh(a); });
    case Op::hyperbolic_tangent: return one([](double a) { return std::tanh(a); });
    case Op::exponential: return one([](double a) { return std::exp(a); });
    case Op::logarithm: return one([](double a) { return std::log(a); });
    case Op::logarithm_10: return one([](double a) { return std::log10(a); });
    case Op::square_root: return one([](double a) { return std::sqrt(a); });
    case Op::absolute: return one([](double a) { return std::abs(a); });
    case Op::sign: return one(sign_of);
    case Op::floor: return one([](double a) { return std::floor(a); });
    case Op::minimum: return two(smaller);
    case Op::maximum: return two(larger);
    case Op::constant:
    case Op::x:
    case Op::y:
    case Op::t:
    case Op::sine:
    case Op::cosine: return;
    }
}

} // namespace dsc::scenes
