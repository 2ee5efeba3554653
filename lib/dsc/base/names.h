// SPDX-License-Identifier: MIT
// Tables of the values of an enum with their names, defined beside the enum. Printing, parsing,
// help texts and tests all use them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace dsc {

/// One value of an enum, and its name on command lines and in files.
template <class Enum>
struct Named {
    Enum value;            ///< the value itself
    std::string_view name; ///< in lower case, with underscores
};
/// Deduces the enum from a literal.
template <class Enum>
Named(Enum, const char*) -> Named<Enum>;

/// All values of an enum, each once, in the order in which they are declared.
template <class Enum, std::size_t n>
using EnumTable = std::array<Named<Enum>, n>;

/// The name of a value; "unknown" for a number that is no value of the enum. O(n).
template <class Enum, std::size_t n>
[[nodiscard]] constexpr std::string_view name_in(const EnumTable<Enum, n>& table,
                                                 std::type_identity_t<Enum> value) {
    for (const auto& one : table) {
        if (one.value == value) {
            return one.name;
        }
    }
    return "unknown";
}

/// The value with this name; empty if there is none. O(n).
template <class Enum, std::size_t n>
[[nodiscard]] constexpr std::optional<Enum> value_in(const EnumTable<Enum, n>& table,
                                                     std::string_view name) {
    for (const auto& one : table) {
        if (one.name == name) {
            return one.value;
        }
    }
    return std::nullopt;
}

/// All names as "a, b, c", for messages and help texts.
template <class Enum, std::size_t n>
[[nodiscard]] std::string names_in(const EnumTable<Enum, n>& table) {
    std::string names;
    for (const auto& one : table) {
        names += names.empty() ? "" : ", ";
        names += one.name;
    }
    return names;
}

} // namespace dsc
