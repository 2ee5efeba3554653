// SPDX-License-Identifier: MIT
// Formulas have the values that C++ gives them, whatever the batch, and errors say where they break
// off.
#include "scenes/file/formula/formula_flow.h"

#include "dsc/base/error.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>
#include <thread>

namespace dsc::scenes::formula_test {
namespace {

using std::numbers::pi;

std::vector<Point<double>> some_positions(std::size_t count) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> coordinate(-1.5, 2.5);
    std::vector<Point<double>> positions(count);
    for (auto& p : positions) {
        p = {coordinate(random), coordinate(random)};
    }
    return positions;
}

std::vector<Point<double>> evaluate(const Velocity& flow, std::span<const Point<double>> positions,
                                    double time = 0.3) {
    std::vector<Point<double>> result(positions.size());
    flow(positions, time, result);
    return result;
}

bool same_bits(const std::vector<Point<double>>& a, const std::vector<Point<double>>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

FormulaFlow formulas(const std::string& u, const std::string& v = "0") {
    return FormulaFlow({.u = u, .v = v, .parameters = {{"a", 0.75}, {"b_2", -2}}});
}

struct Example {
    const char* formula;
    double (*value)(double x, double y, double t);
};

const std::array examples{
    Example{"1", [](double, double, double) { return 1.0; }},
    Example{"x", [](double x, double, double) { return x; }},
    Example{"-x^2", [](double x, double, double) { return -x * x; }},
    Example{"(-x)^3", [](double x, double, double) { return -x * x * x; }},
    Example{"2^-y", [](double, double y, double) { return std::pow(2, -y); }},
    Example{"2^3^2 + x", [](double x, double, double) { return 512 + x; }},
    Example{"x - y - 1", [](double x, double y, double) { return x - y - 1; }},
    Example{"x / 2 / y", [](double x, double y, double) { return x / 2 / y; }},
    Example{"x * -y + +1", [](double x, double y, double) { return -x * y + 1; }},
    Example{"a*x + b_2*y", [](double x, double y, double) { return 0.75 * x - 2 * y; }},
    Example{"t*x + t^2", [](double x, double, double t) { return t * x + t * t; }},
    Example{"cos(pi*t/8)*y", [](double, double y, double t) { return std::cos(pi * t / 8) * y; }},
    Example{"sin(x) + cos(x)", [](double x, double, double) { return std::sin(x) + std::cos(x); }},
    Example{"sin(-2*pi*x/3)", [](double x, double, double) { return std::sin(-2 * pi * x / 3); }},
    Example{"cos(x*y) * sin(x*y)",
            [](double x, double y, double) { return std::cos(x * y) * std::sin(x * y); }},
    Example{"sin(2*pi*x) - cos(-2*pi*y)",
            [](double x, double y, double) { return std::sin(2 * pi * x) - std::cos(2 * pi * y); }},
    Example{"sin(-pi*x*2) + sin(pi*x)^2",
            [](double x, double, double) {
                return -std::sin(2 * pi * x) + std::pow(std::sin(pi * x), 2);
            }},
    Example{"sin(pi/6) * x", [](double x, double, double) { return 0.5 * x; }},
    Example{"exp(-x^2 - y^2)", [](double x, double y, double) { return std::exp(-x * x - y * y); }},
    Example{"sqrt(x^2 + y^2)", [](double x, double y, double) { return std::hypot(x, y); }},
    Example{"abs(x)^0.5", [](double x, double, double) { return std::sqrt(std::abs(x)); }},
    Example{
        "ln(abs(x)) + log10(abs(y))",
        [](double x, double y, double) { return std::log(std::abs(x)) + std::log10(std::abs(y)); }},
    Example{"atan2(y, x) + atan(x)",
            [](double x, double y, double) { return std::atan2(y, x) + std::atan(x); }},
    Example{"tan(x) + tanh(y) + sinh(x) - cosh(y)",
            [](double x, double y, double) {
                return std::tan(x) + std::tanh(y) + std::sinh(x) - std::cosh(y);
            }},
    Example{"asin(x/3) + acos(y/3)",
            [](double x, double y, double) { return std::asin(x / 3) + std::acos(y / 3); }},
    Example{"min(x, y, 0.5) + max(x, 1)",
            [](double x, double y, double) {
                return std::min({x, y, 0.5}) + std::max(x, 1.0);
            }},
    Example{"sign(x) + floor(y)",
            [](double x, double y, double) { return (x > 0 ? 1 : -1) + std::floor(y); }},
    Example{"x < y ? 1 : x > 1 ? 2 : 3",
            [](double x, double y, double) { return x < y   ? 1.0
                                                    : x > 1 ? 2.0
                                                            : 3.0; }},
    Example{"(x <= 0.5) + 2*(y >= 0.5) + 4*(1 == 1) + 8*(x != x)",
            [](double x, double y, double) {
                return (x <= 0.5 ? 1.0 : 0.0) + (y >= 0.5 ? 2.0 : 0.0) + 4;
            }},
};

TEST(Formula, HasTheValuesOfItsText) {
    const auto positions = some_positions(300);
    constexpr double time = 0.3;
    for (const Example& example : examples) {
        SCOPED_TRACE(example.formula);
        const auto result = evaluate(formulas(example.formula, example.formula), positions, time);
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const double right = example.value(positions[i].x(), positions[i].y(), time);
            ASSERT_NEAR(result[i].x(), right, 1e-14 * (1 + std::abs(right)));
            ASSERT_EQ(result[i].x(), result[i].y());
        }
    }
}

TEST(Formula, OfTheSwirlHasTheBitsOfTheSwirl) {
    const auto positions = some_positions(1000);
    const FormulaFlow formula = formulas("2*sin(pi*x)*sin(pi*y)*sin(pi*x)*cos(pi*y)",
                                         "-(2*sin(pi*x)*sin(pi*y)*sin(pi*y)*cos(pi*x))");
    EXPECT_TRUE(same_bits(evaluate(formula, positions), evaluate(Swirl{}, positions)));
}

TEST(Formula, DoesNotDependOnTheBatchOrTheThread) {
    const auto positions = some_positions(517);
    const FormulaFlow formula =
        formulas("exp(-x^2)*sin(3*x*y) + t*y^1.5 + (x < y ? cos(x) : sqrt(x))", "cos(x+y)/x - t");
    const auto whole = evaluate(formula, positions);
    for (const std::size_t size : {1U, 2U, 3U, 7U, 127U, 128U, 129U, 400U}) {
        std::vector<Point<double>> parts(positions.size());
        for (std::size_t begin = 0; begin < positions.size(); begin += size) {
            const std::size_t count = std::min(size, positions.size() - begin);
            formula({&positions[begin], count}, 0.3, {&parts[begin], count});
        }
        EXPECT_TRUE(same_bits(whole, parts)) << size;
    }
    std::vector<Point<double>> in_place = positions;
    formula(in_place, 0.3, in_place);
    EXPECT_TRUE(same_bits(whole, in_place));

    std::array<std::vector<Point<double>>, 4> results;
    {
        std::vector<std::jthread> threads;
        for (auto& result : results) {
            threads.emplace_back([&] {
                for (int i = 0; i < 50; ++i) {
                    result = evaluate(formula, positions);
                }
            });
        }
    }
    for (const auto& result : results) {
        EXPECT_TRUE(same_bits(whole, result));
    }
}

TEST(Formula, WithoutAValueIsNotFinite) {
    const std::vector<Point<double>> positions{{0, -1}};
    const auto result = evaluate(formulas("1/x", "sqrt(y)"), positions);
    EXPECT_TRUE(std::isinf(result[0].x()));
    EXPECT_TRUE(std::isnan(result[0].y()));
    for (const char* hidden : {"min(1, sqrt(y))", "min(sqrt(y), 1)", "max(1, sqrt(y))",
                               "max(sqrt(y), 1)", "min(1, 2, sqrt(y), 3)"}) {
        EXPECT_TRUE(std::isnan(evaluate(formulas(hidden), positions)[0].x())) << hidden;
    }
}

struct BadFormula {
    std::string formula;
    int character; ///< 0: none is named
    std::string allowed;
};

TEST(Formula, ErrorsSayWhereItBreaksOff) {
    std::string deep;
    for (int i = 0; i < 100; ++i) {
        deep += "(";
    }
    std::string sum = "x";
    for (int i = 0; i < 600; ++i) {
        sum += "+x*" + std::to_string(i);
    }
    const std::vector<BadFormula> bad{
        {"", 1, "a number"},
        {"x +", 4, "a number"},
        {"sin(x", 6, "')'"},
        {"x y", 3, "an operator"},
        {"x + z", 5, "x, y, t, pi"},
        {"sin x", 5, "'('"},
        {"atan2(x)", 8, "2 arg"},
        {"sin(x, y)", 6, "')'"},
        {"x ? 1", 6, "':'"},
        {"1e999", 1, "a number"},
        {"x;y", 2, "an operator"},
        {"2 ** x", 4, "a number"},
        {deep, 65, "levels"},
        {sum, 0, "at most"},
        {std::string(5000, '-'), 0, "4096"},
        {"x^x^x^x^" + std::string(300, ' ') + "$", 309, "a number"},
    };
    for (const auto& [formula, character, allowed] : bad) {
        SCOPED_TRACE(formula.substr(0, 40));
        try {
            (void)FormulaFlow({.u = "x", .v = formula, .where_u = "there", .where_v = "there"});
            ADD_FAILURE() << "accepted";
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), "there");
            EXPECT_NE(error.allowed().find(allowed), std::string::npos) << error.what();
            if (character > 0) {
                EXPECT_NE(error.problem().find("character " + std::to_string(character) + " "),
                          std::string::npos)
                    << error.what();
            }
        }
    }
}

TEST(Formula, ParametersHaveNamesOfTheirOwn) {
    for (const char* name : {"a", "A2", "speed_of_sound", "xx"}) {
        EXPECT_TRUE(is_parameter_name(name)) << name;
    }
    for (const char* name : {"", "x", "y", "t", "sin", "2a", "_a", "a-b", "a b"}) {
        EXPECT_FALSE(is_parameter_name(name)) << name;
    }
}

} // namespace
} // namespace dsc::scenes::formula_test
