// SPDX-License-Identifier: MIT
#include "limits.h"

#include "checks.h"

#include "dsc/base/error.h"
#include "scenes/file/case_reader.h"
#include "scenes/file/excerpt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace dsc::gate {

namespace {

using scenes::TableReader;

constexpr scenes::Bounds any{-1e300, 1e300};

const std::array<Rule, 6>& rules() {
    static const std::array<Rule, 6> all{{
        {"required", 1.02, 3}, // met by a wide margin, but not by any margin
        {"kept", 1.02, 1.9},   // kept from an earlier, better measurement
        {"half as much again", 1.4, 1.9, 1.5},
        {"a tenth above", 1.05, 1.2, 1.1},
        {"a tenth below", 0.8, 0.95, 0.9},
        {"less 15 %", 0.8, 0.9, 0.85},
    }};
    return all;
}

// Finds limits that were loosened, or that the stored measurement nearly reaches, without a run.
void check_rule(const TableReader& limits, const Check& check, const Limit& limit) {
    const double measured = limit.measured.value();
    if (std::abs(measured) <= rounding_error) {
        if (!(limit.value >= 0 && limit.value <= rounding_error)) {
            limits.refuse(check.name,
                          "the measurement is a rounding error, but the limit is larger",
                          "0 to 1e-12");
        }
        return;
    }
    const Rule& rule = find_rule(limit.rule);
    const double ratio =
        rule.factor == 1 && check.at_least ? measured / limit.value : limit.value / measured;
    if (!(ratio >= rule.min && ratio <= rule.max)) {
        limits.refuse(check.name,
                      "the limit does not follow its rule, " + rule.name + " of " +
                          to_text(measured),
                      to_text(rule.min) + " to " + to_text(rule.max) + " times that");
    }
}

} // namespace

std::string few_digits(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

const Rule& find_rule(const std::string& name) {
    const auto found = std::ranges::find(rules(), name, &Rule::name);
    if (found == rules().end()) {
        throw InputError({.what = "unknown rule",
                          .where = "rule",
                          .value = "'" + name + "'",
                          .allowed = scenes::name_list(rules(), &Rule::name)});
    }
    return *found;
}

std::string Limit::reason() const {
    std::string text = rule + (around              ? ", off " + few_digits(*around, 5)
                               : histogram.empty() ? ""
                                                   : ", off the stored histogram");
    if (measured) {
        text += (orders > 0 ? "; in " + std::to_string(orders) + " orders " : "; measured ") +
                few_digits(*measured, 3);
    }
    return text + (note.empty() ? "" : "; " + note) + " (" + where + ")";
}

double Limit::worse_by(double figure, bool at_least) const {
    if (!measured || orders > 0 || std::abs(*measured) <= rounding_error) {
        return 0;
    }
    const double grown = figure / *measured - 1;
    return at_least ? -grown : grown;
}

Limit read_limit(const TableReader& limits, const std::optional<TableReader>& defaults,
                 const Check& check) {
    const toml::table empty;
    const TableReader nothing(empty, check.name, limits.file());
    const auto table = limits.table_if_one(check.name);
    const TableReader own = table.value_or(nothing);
    const TableReader common =
        defaults && defaults->has(check.name) ? defaults->table(check.name) : nothing;
    for (const TableReader& one : {own, common}) {
        one.allow({"at_most", "at_least", "around", "histogram", "measured", "rule", "orders",
                   "note", "at"});
    }
    const scenes::CaseReader reader(common, &own);
    const auto number = [&](const std::string& key) {
        return reader.has(key) ? std::optional(reader.of(key).number(key, any)) : std::nullopt;
    };
    const auto text = [&](const std::string& key, const std::string& otherwise) {
        return reader.has(key) ? reader.of(key).text(key) : otherwise;
    };

    Limit limit{.where = limits.where(check.name)};
    const std::string wanted = check.at_least ? "at_least" : "at_most";
    const std::string other = check.at_least ? "at_most" : "at_least";
    if (table && reader.has(other)) {
        limits.refuse(check.name, "the limit has the wrong bound, " + other, wanted);
    }
    if (table && !reader.has(wanted)) {
        limits.refuse(check.name, "a limit is missing", wanted + " = a number");
    }
    limit.value = table ? *number(wanted) : limits.number(check.name, any);
    limit.around = number("around");
    if (check.stores == Stores::figure && !limit.around) {
        limits.refuse(check.name, "the stored figure is missing", "around = a number");
    }
    if (check.stores == Stores::histogram) {
        const auto wrong = [&] {
            limits.refuse(check.name, "the stored histogram is missing or has other bins",
                          "histogram = " + std::to_string(check.bins) + " counts");
        };
        if (!table || !reader.has("histogram")) {
            wrong();
        }
        for (const int count :
             reader.of("histogram").integers("histogram", 0, std::numeric_limits<int>::max())) {
            limit.histogram.push_back(static_cast<std::uint64_t>(count));
        }
        if (limit.histogram.size() != check.bins ||
            std::ranges::all_of(limit.histogram, [](std::uint64_t count) { return count == 0; })) {
            wrong();
        }
    }
    limit.measured = number("measured");
    limit.orders = reader.has("orders") ? reader.of("orders").integer("orders", 0, 10'000) : 0;
    limit.rule = text("rule", limit.rule);
    scenes::at_key(limits, check.name, [&] { (void)find_rule(limit.rule); });
    limit.note = text("note", "");
    limit.at = text("at", "");
    if (limit.measured) {
        check_rule(limits, check, limit);
    } else if (find_rule(limit.rule).factor != 1) {
        limits.refuse(check.name, "the rule needs a measurement", "measured = a number");
    }
    return limit;
}

} // namespace dsc::gate
