// SPDX-License-Identifier: MIT
#include "scenes/file/formula/operations.h"

#include "flows/sine_cosine.h"

#include <array>
#include <cmath>

namespace dsc::scenes {

namespace {

constexpr int any_number = 64;

// A function of one or two numbers, on rows. Rows are the same or apart, never shifted against each
// other.
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

// min and max are NaN where an argument is, so that it is noticed.
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

} // namespace

const RowOperation negate_rows = on_rows([](double a) { return -a; });
const RowOperation multiply_rows = multiply;
const RowOperation divide_rows = divide;
const RowOperation power_rows = on_rows([](double a, double b) { return std::pow(a, b); });
const RowOperation choose_rows = [](const double* a, const double* b, const double* c,
                                    double* result, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        result[i] = a[i] != 0 ? b[i] : c[i];
    }
};
const RowOperation sine_rows = sine;
const RowOperation cosine_rows = cosine;
const RowOperation sine_cosine_pi_rows = [](const double* a, const double*, const double*,
                                            double* result, std::size_t count) {
    sine_cosine_pi(a, count, result, result + formula_row_length);
};

std::span<const NamedOperation> formula_functions() { return functions; }

std::span<const NamedOperation> formula_operators(int level) {
    if (level == 0) {
        return comparisons;
    }
    return level == 1 ? std::span<const NamedOperation>(sums) : products;
}

} // namespace dsc::scenes
