// SPDX-License-Identifier: MIT
// A table of a TOML file, read key by key: each value is checked as it is read, and errors name the
// file, line, key, value and what is allowed.
#pragma once

#include "dsc/base/error.h"
#include "dsc/base/names.h"
#include "dsc/base/types.h"
#include "scenes/file/excerpt.h"

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dsc::scenes {

/// Bound of coordinates, lengths and counts of points in a scene file.
inline constexpr double largest_coordinate = 1e15;
inline constexpr std::size_t max_points = 1'000'000;
inline constexpr int largest_phase = 1'000'000;

/// A range of numbers, bounds included.
struct Bounds {
    double low = -largest_coordinate;
    double high = largest_coordinate;
};

/// A length above 0.
inline constexpr Bounds positive_length{1e-30, largest_coordinate};

/// The table and the file's name must outlive the reader. Every function throws InputError for a
/// value of the wrong type or out of bounds.
class TableReader {
public:
    /// `name` is the table's name in the file, for errors; empty: the whole file.
    TableReader(const toml::table& table, std::string name, const std::filesystem::path& file)
        : table_(&table), name_(std::move(name)), file_(&file) {}

    [[nodiscard]] bool has(const std::string& key) const { return find(key) != nullptr; }
    [[nodiscard]] bool is_list(const std::string& key) const;
    [[nodiscard]] bool is_text(const std::string& key) const;
    [[nodiscard]] std::vector<std::string> keys() const;
    [[nodiscard]] const std::filesystem::path& file() const { return *file_; }
    [[nodiscard]] const std::string& name() const { return name_; }

    [[nodiscard]] double number(const std::string& key, Bounds bounds = {}) const;
    [[nodiscard]] double number_or(double otherwise, const std::string& key,
                                   Bounds bounds = {}) const;
    [[nodiscard]] int integer(const std::string& key, int low, int high) const;
    [[nodiscard]] bool flag_or(bool otherwise, const std::string& key) const;
    [[nodiscard]] std::string text(const std::string& key) const;
    [[nodiscard]] std::vector<std::string> texts(const std::string& key) const;
    [[nodiscard]] std::vector<double> numbers(const std::string& key, Bounds bounds = {}) const;
    [[nodiscard]] std::vector<int> integers(const std::string& key, int low, int high) const;
    /// Phases from `min` to `largest_phase`.
    [[nodiscard]] Phase phase(const std::string& key, int min = 0) const;
    [[nodiscard]] Phase phase_or(Phase otherwise, const std::string& key) const;
    [[nodiscard]] std::vector<Phase> phases(const std::string& key, int min = 0) const;
    [[nodiscard]] Point<double> point(const std::string& key) const;
    [[nodiscard]] Point<double> point_or(const Point<double>& otherwise,
                                         const std::string& key) const;
    [[nodiscard]] std::vector<Point<double>> points(const std::string& key) const;
    [[nodiscard]] TableReader table(const std::string& key) const;
    /// A list of tables; a single table is a list of one; empty if there is no such key.
    [[nodiscard]] std::vector<TableReader> tables(const std::string& key) const;

    /// The table of this key; empty if its value is not a table.
    [[nodiscard]] std::optional<TableReader> table_if_one(const std::string& key) const;
    /// The value as text for --set: a number, a text, or yes and no.
    [[nodiscard]] std::string setting(const std::string& key) const;
    /// Throws InputError for the first key that is not one of these.
    void allow(std::span<const std::string> keys) const;
    void allow(std::initializer_list<std::string> keys) const {
        allow(std::span(keys.begin(), keys.size()));
    }
    /// The only one of these keys that the table has. Throws InputError if it has none of them or
    /// more than one.
    [[nodiscard]] std::string one_of(std::span<const std::string> keys) const;

    /// "scene.toml:12: [domain] low"; without a key, the table itself.
    [[nodiscard]] std::string where(const std::string& key = "") const;
    /// `value` as it is in the file; without a key, that of the whole table is "a table".
    [[noreturn]] void refuse(const std::string& key, const std::string& what,
                             const std::string& allowed) const;

private:
    [[nodiscard]] const toml::node& at(const std::string& key) const;
    [[nodiscard]] std::string place(const toml::source_region& source,
                                    const std::string& key) const;
    [[nodiscard]] TableReader reader(const toml::table& table, const std::string& key) const {
        return {table, name_.empty() ? key : name_ + "." + key, *file_};
    }
    /// The value of the node, or the list of values of an array, by `convert`; refuses nodes that
    /// `convert` cannot convert.
    template <class Convert>
    [[nodiscard]] auto converted(const std::string& key, Convert convert,
                                 const std::string& allowed) const;
    template <class Convert>
    [[nodiscard]] auto list(const std::string& key, Convert convert,
                            const std::string& allowed) const;

    /// The value of a key, or of its old name of release 0.1.
    [[nodiscard]] const toml::node* find(const std::string& key) const;

    const toml::table* table_;
    std::string name_;
    const std::filesystem::path* file_;
};

/// Calls `what` and adds the place of the key to its errors; that of the whole table if `key` is
/// empty.
template <class What>
auto at_key(const TableReader& reader, const std::string& key, What what) {
    try {
        return what();
    } catch (const InputError& error) {
        throw InputError({.what = error.problem(),
                          .where = reader.where(key),
                          .value = excerpt(error.value()),
                          .allowed = error.allowed()});
    }
}

/// The enum value named under the key; `otherwise` if there is no such key.
template <class Enum, std::size_t n>
[[nodiscard]] Enum read_choice(const TableReader& reader, const std::string& key,
                               const EnumTable<Enum, n>& table, Enum otherwise) {
    if (!reader.has(key)) {
        return otherwise;
    }
    const auto value = value_in(table, reader.text(key));
    if (!value) {
        reader.refuse(key, "bad value", names_in(table));
    }
    return *value;
}

/// Throws InputError, with the line, for a text that is not TOML.
[[nodiscard]] toml::table parse_toml(const std::string& text, const std::filesystem::path& file);

} // namespace dsc::scenes
