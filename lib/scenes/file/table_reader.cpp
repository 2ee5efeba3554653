// SPDX-License-Identifier: MIT
#include "scenes/file/table_reader.h"

#include "dsc/base/error.h"
#include "dsc/base/renamed.h"
#include "scenes/file/excerpt.h"

#include <algorithm>
#include <iostream>
#include <sstream>

namespace dsc::scenes {

namespace {

std::string as_written(const toml::node& node) {
    std::ostringstream stream;
    node.visit([&](const auto& value) { stream << value; });
    return excerpt(stream.str());
}

std::optional<double> finite_number(const toml::node& node, Bounds bounds) {
    if (!node.is_number()) {
        return std::nullopt;
    }
    const auto value = node.value<double>();
    // Written so that NaN is refused too.
    return value && *value >= bounds.low && *value <= bounds.high ? value : std::nullopt;
}

std::optional<int> bounded_integer(const toml::node& node, int low, int high) {
    const auto value = node.value_exact<std::int64_t>();
    return value && *value >= low && *value <= high ? std::optional(static_cast<int>(*value))
                                                    : std::nullopt;
}

std::optional<Point<double>> finite_point(const toml::node& node) {
    const toml::array* array = node.as_array();
    if (array == nullptr || array->size() != 2) {
        return std::nullopt;
    }
    const auto x = finite_number((*array)[0], {});
    const auto y = finite_number((*array)[1], {});
    return x && y ? std::optional(Point<double>(*x, *y)) : std::nullopt;
}

template <class Value>
std::optional<Value> exact(const toml::node& node) {
    return node.value_exact<Value>();
}

std::string range(const std::string& kind, double low, double high) {
    return kind + " from " + to_text(low) + " to " + to_text(high);
}

const std::string a_point = "two numbers [x, y] from -1e+06 to 1e+06";

} // namespace

std::string TableReader::place(const toml::source_region& source, const std::string& key) const {
    std::string text = file_->string();
    if (source.begin.line > 0) {
        text += ':' + std::to_string(source.begin.line);
    }
    text += (name_.empty() ? "" : ": [" + name_ + "]");
    return key.empty() ? text : text + (name_.empty() ? ": " : " ") + key;
}

std::string TableReader::where(const std::string& key) const {
    const toml::node* node = key.empty() ? nullptr : find(key);
    return place((node != nullptr ? node : table_)->source(), key);
}

void TableReader::refuse(const std::string& key, const std::string& what,
                         const std::string& allowed) const {
    const toml::node* node = key.empty() ? nullptr : find(key);
    throw InputError({.what = what,
                      .where = where(key),
                      .value = node != nullptr ? as_written(*node) : "a table",
                      .allowed = allowed});
}

const toml::node& TableReader::at(const std::string& key) const {
    const toml::node* node = find(key);
    if (node == nullptr) {
        const std::string names = name_list(keys());
        throw InputError({.what = "key missing",
                          .where = where(),
                          .value = names.empty() ? "nothing" : excerpt(names),
                          .allowed = "with the key " + key});
    }
    return *node;
}

const toml::node* TableReader::find(const std::string& key) const {
    const toml::node* node = table_->get(key);
    const auto* renamed = std::ranges::find(renamed_options, key, &RenamedOption::now);
    return node != nullptr || renamed == renamed_options.end() ? node : table_->get(renamed->old);
}

bool TableReader::is_list(const std::string& key) const { return at(key).is_array(); }

bool TableReader::is_text(const std::string& key) const { return at(key).is_string(); }

std::vector<std::string> TableReader::keys() const {
    std::vector<std::string> names;
    for (const auto& entry : *table_) {
        names.emplace_back(entry.first.str());
    }
    return names;
}

template <class Convert>
auto TableReader::converted(const std::string& key, Convert convert,
                            const std::string& allowed) const {
    const auto value = convert(at(key));
    if (!value) {
        refuse(key, "bad value", allowed);
    }
    return *value;
}

template <class Convert>
auto TableReader::list(const std::string& key, Convert convert, const std::string& allowed) const {
    const toml::array* array = at(key).as_array();
    if (array == nullptr || array->size() > max_points) {
        refuse(key, "bad value", "a list of " + allowed + ", at most " + to_text(max_points));
    }
    std::vector<typename decltype(convert(at(key)))::value_type> values;
    for (const toml::node& node : *array) {
        const auto value = convert(node);
        if (!value) {
            throw InputError({.what = "bad value " + std::to_string(values.size() + 1),
                              .where = place(node.source(), key),
                              .value = as_written(node),
                              .allowed = allowed});
        }
        values.push_back(*value);
    }
    return values;
}

double TableReader::number(const std::string& key, Bounds bounds) const {
    return converted(
        key, [&](const toml::node& node) { return finite_number(node, bounds); },
        range("a number", bounds.low, bounds.high));
}

double TableReader::number_or(double otherwise, const std::string& key, Bounds bounds) const {
    return has(key) ? number(key, bounds) : otherwise;
}

int TableReader::integer(const std::string& key, int low, int high) const {
    return converted(
        key, [&](const toml::node& node) { return bounded_integer(node, low, high); },
        range("a whole number", low, high));
}

bool TableReader::flag_or(bool otherwise, const std::string& key) const {
    return has(key) ? converted(key, exact<bool>, "true or false") : otherwise;
}

std::string TableReader::text(const std::string& key) const {
    return converted(key, exact<std::string>, "a text in quotes");
}

std::vector<std::string> TableReader::texts(const std::string& key) const {
    return list(key, exact<std::string>, "texts in quotes");
}

std::vector<double> TableReader::numbers(const std::string& key, Bounds bounds) const {
    return list(
        key, [&](const toml::node& node) { return finite_number(node, bounds); },
        range("numbers", bounds.low, bounds.high));
}

std::vector<int> TableReader::integers(const std::string& key, int low, int high) const {
    return list(
        key, [&](const toml::node& node) { return bounded_integer(node, low, high); },
        range("whole numbers", low, high));
}

Phase TableReader::phase(const std::string& key, int min) const {
    return static_cast<Phase>(integer(key, min, largest_phase));
}

Phase TableReader::phase_or(Phase otherwise, const std::string& key) const {
    return has(key) ? phase(key) : otherwise;
}

std::vector<Phase> TableReader::phases(const std::string& key, int min) const {
    const std::vector<int> numbers = integers(key, min, largest_phase);
    return {numbers.begin(), numbers.end()};
}

Point<double> TableReader::point(const std::string& key) const {
    return converted(key, finite_point, a_point);
}

Point<double> TableReader::point_or(const Point<double>& otherwise, const std::string& key) const {
    return has(key) ? point(key) : otherwise;
}

std::vector<Point<double>> TableReader::points(const std::string& key) const {
    return list(key, finite_point, "points: " + a_point);
}

TableReader TableReader::table(const std::string& key) const {
    const toml::table* table = at(key).as_table();
    if (table == nullptr) {
        refuse(key, "bad value", "a table: [" + key + "], or " + key + " = { ... }");
    }
    return reader(*table, key);
}

std::optional<TableReader> TableReader::table_if_one(const std::string& key) const {
    return at(key).is_table() ? std::optional(table(key)) : std::nullopt;
}

std::vector<TableReader> TableReader::tables(const std::string& key) const {
    if (!has(key)) {
        return {};
    }
    if (at(key).is_table()) {
        return {table(key)};
    }
    const auto reader_of = [&](const toml::node& node) -> std::optional<TableReader> {
        const toml::table* one = node.as_table();
        return one == nullptr ? std::nullopt : std::optional(reader(*one, key));
    };
    return list(key, reader_of, "tables: [[" + key + "]]");
}

std::string TableReader::setting(const std::string& key) const {
    const toml::node& node = at(key);
    if (const auto text = node.value_exact<std::string>()) {
        return *text;
    }
    if (const auto flag = node.value_exact<bool>()) {
        return *flag ? "yes" : "no";
    }
    if (const auto integer = node.value_exact<std::int64_t>()) {
        return std::to_string(*integer);
    }
    if (const auto number = node.value_exact<double>()) {
        return to_text(*number);
    }
    refuse(key, "bad value", "a number, or a text in quotes");
}

void TableReader::allow(std::span<const std::string> keys) const {
    for (const auto& entry : *table_) {
        const std::string key(entry.first.str());
        const auto is_allowed = [&](std::string_view one) {
            return std::ranges::find(keys, one) != keys.end();
        };
        if (is_allowed(key)) {
            continue;
        }
        const RenamedOption* renamed = renamed_option(key);
        if (renamed != nullptr && is_allowed(renamed->now) && !table_->contains(renamed->now)) {
            std::cerr << place(entry.first.source(), "") << ": " << renamed->warning() << '\n';
        } else {
            throw InputError({.what = "unknown key",
                              .where = place(entry.first.source(), ""),
                              .value = quoted_excerpt(key),
                              .allowed = name_list(keys)});
        }
    }
}

std::string TableReader::one_of(std::span<const std::string> keys) const {
    std::string found;
    for (const std::string& key : keys) {
        if (!has(key)) {
            continue;
        }
        if (!found.empty()) {
            refuse(key, "only one of two keys may be given, " + found + " and " + key,
                   "one of them");
        }
        found = key;
    }
    if (found.empty()) {
        throw InputError({.what = "key missing",
                          .where = where(),
                          .value = "none",
                          .allowed = "one of: " + name_list(keys)});
    }
    return found;
}

toml::table parse_toml(const std::string& text, const std::filesystem::path& file) {
    try {
        return toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        const auto& at = error.source().begin;
        std::istringstream lines(text);
        std::string line;
        for (toml::source_index i = 0; i < at.line && std::getline(lines, line); ++i) {
        }
        throw InputError({.what = excerpt(error.description()),
                          .where = file.string() + ':' + std::to_string(at.line) + ", column " +
                                   std::to_string(at.column),
                          .value = quoted_excerpt(line),
                          .allowed = "TOML: tables in [brackets], key = value, texts in quotes"});
    }
}

} // namespace dsc::scenes
