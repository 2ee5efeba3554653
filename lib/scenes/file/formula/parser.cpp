// SPDX-License-Identifier: MIT
// Parses the text of a formula to a graph.
//
//     formula    = comparison [ "?" formula ":" formula ]
//     comparison = sum [ ( "<" | "<=" | ">" | ">=" | "==" | "!=" ) sum ]
//     sum        = product { ( "+" | "-" ) product }
//     product    = signed { ( "*" | "/" ) signed }
//     signed     = { "+" | "-" } power
//     power      = operand [ "^" signed ]
//     operand    = number | name | function "(" formula { "," formula } ")" | "(" formula ")"
#include "dsc/base/error.h"
#include "scenes/file/excerpt.h"
#include "scenes/file/formula/formula_flow.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <numbers>
#include <optional>

namespace dsc::scenes {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

std::optional<FormulaNodeId> variable_called(std::string_view name, std::string_view variables) {
    const std::size_t place = variables.find(name);
    return name.size() == 1 && place != std::string_view::npos
               ? std::optional(static_cast<FormulaNodeId>(place))
               : std::nullopt;
}

const NamedOperation* function_called(std::string_view name) {
    const auto all = formula_functions();
    const auto found = std::ranges::find(all, name, &NamedOperation::name);
    return found == all.end() ? nullptr : &*found;
}

class FormulaParser {
public:
    FormulaParser(std::string_view text, const FormulaParameters& known, const std::string& where,
                  FormulaGraph& graph)
        : text_(text), known_(known), where_(where), graph_(graph) {}

    FormulaNodeId parse() {
        if (text_.size() > longest_formula) {
            throw InputError({.what = "formula too long",
                              .where = where_,
                              .value = std::to_string(text_.size()) + " characters",
                              .allowed = "at most " + std::to_string(longest_formula)});
        }
        const FormulaNodeId whole = formula();
        if (skip_blanks(); at_ < text_.size()) {
            refuse("unexpected text", "an operator, or the end");
        }
        check_size();
        return whole;
    }

private:
    [[noreturn]] void refuse(const std::string& what, const std::string& allowed) const {
        throw InputError(
            {.what = what + " at character " + std::to_string(at_ + 1) + " of the formula",
             .where = where_,
             .value = at_ < text_.size() ? quoted_excerpt(text_.substr(at_))
                                         : "the end of " + quoted_excerpt(text_),
             .allowed = allowed});
    }

    void check_size() const {
        if (graph_.nodes().size() > max_formula_nodes) {
            refuse("too many operations",
                   "at most " + std::to_string(max_formula_nodes) + " in both components");
        }
    }

    void skip_blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' ||
                                      text_[at_] == '\n' || text_[at_] == '\r')) {
            ++at_;
        }
    }

    bool take(std::string_view token) {
        skip_blanks();
        if (!text_.substr(at_).starts_with(token)) {
            return false;
        }
        at_ += token.size();
        return true;
    }

    void expect(std::string_view token) {
        if (!take(token)) {
            refuse("something is missing", in_single_quotes(token));
        }
    }

    FormulaNodeId formula() {
        if (++depth_ > deepest_formula) {
            refuse("formula too deep",
                   "at most " + std::to_string(deepest_formula) + " levels of parentheses");
        }
        FormulaNodeId value = operands_of_level(0);
        if (take("?")) {
            const FormulaNodeId yes = formula();
            expect(":");
            value = graph_.apply(choose_rows, value, yes, formula());
        }
        --depth_;
        return value;
    }

    // Parses operands joined by the operators of a level; comparisons cannot be chained.
    FormulaNodeId operands_of_level(int level) {
        if (level == operator_levels) {
            return with_sign();
        }
        FormulaNodeId value = operands_of_level(level + 1);
        while (const RowOperation operation = operator_of_level(level)) {
            value = graph_.apply(operation, value, operands_of_level(level + 1));
            if (level == 0) {
                break;
            }
        }
        return value;
    }

    RowOperation operator_of_level(int level) {
        const auto all = formula_operators(level);
        const auto found = std::ranges::find_if(all, [&](const auto& o) { return take(o.name); });
        return found == all.end() ? nullptr : found->operation;
    }

    FormulaNodeId with_sign() {
        bool is_negative = false;
        while (true) {
            if (take("-")) {
                is_negative = !is_negative;
            } else if (!take("+")) {
                break;
            }
        }
        const FormulaNodeId value = power();
        return is_negative ? graph_.apply(negate_rows, value) : value;
    }

    FormulaNodeId power() {
        const FormulaNodeId base = operand();
        if (!take("^")) {
            return base;
        }
        if (++depth_ > deepest_formula) {
            refuse("formula too deep", "fewer powers of powers");
        }
        const FormulaNodeId exponent = with_sign();
        --depth_;
        return graph_.apply(power_rows, base, exponent);
    }

    FormulaNodeId operand() {
        check_size();
        if (take("(")) {
            const FormulaNodeId value = formula();
            expect(")");
            return value;
        }
        if (at_ < text_.size() && (is_digit(text_[at_]) || text_[at_] == '.')) {
            return number();
        }
        if (at_ < text_.size() && is_letter(text_[at_])) {
            return name();
        }
        refuse("something is missing", "a number, a name, or a parenthesis");
    }

    FormulaNodeId number() {
        double value = 0;
        const char* begin = text_.data() + at_;
        const auto [stop, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error != std::errc{}) {
            refuse("bad number", "a number such as 0.25 or 1e-3");
        }
        at_ += static_cast<std::size_t>(stop - begin);
        return graph_.constant(value);
    }

    FormulaNodeId name() {
        const std::size_t begin = at_;
        std::size_t end = begin;
        while (end < text_.size() && is_of_name(text_[end])) {
            ++end;
        }
        const std::string_view called = text_.substr(begin, end - begin);
        if (const NamedOperation* function = function_called(called)) {
            at_ = end;
            return call(*function);
        }
        FormulaNodeId value = no_formula_node;
        if (const auto variable = variable_called(called, graph_.variables())) {
            value = *variable;
        } else if (const auto found = known_.find(called); found != known_.end()) {
            value = graph_.constant(found->second);
        } else if (called == "pi") {
            value = graph_.constant(std::numbers::pi);
        } else {
            refuse("unknown name", all_names());
        }
        at_ = end;
        return value;
    }

    FormulaNodeId call(const NamedOperation& function) {
        expect("(");
        FormulaNodeId value = formula();
        int count = 1;
        for (; count < function.max_arguments && take(","); ++count) {
            value = graph_.apply(function.operation, value, formula());
        }
        if (count < function.min_arguments) {
            refuse("argument missing", std::to_string(function.min_arguments) + " arguments of " +
                                           std::string(function.name));
        }
        expect(")");
        return count == 1 ? graph_.apply(function.operation, value) : value;
    }

    [[nodiscard]] std::string all_names() const {
        std::string names = graph_.variables().size() == 4 ? "x, y, z, t, pi" : "x, y, t, pi";
        for (const auto& parameter : known_) {
            names += ", " + parameter.first;
        }
        for (const NamedOperation& function : formula_functions()) {
            names += ", " + std::string(function.name) + "()";
        }
        return names;
    }

    std::string_view text_;
    const FormulaParameters& known_;
    const std::string& where_;
    FormulaGraph& graph_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

} // namespace

FormulaNodeId parse_formula(std::string_view text, const FormulaParameters& known,
                            const std::string& where, FormulaGraph& graph) {
    return FormulaParser(text, known, where, graph).parse();
}

bool is_parameter_name(std::string_view name) {
    return !name.empty() && is_letter(name.front()) && std::ranges::all_of(name, is_of_name) &&
           !variable_called(name, FormulaGraph().variables()) && function_called(name) == nullptr;
}

} // namespace dsc::scenes
