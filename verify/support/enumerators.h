// SPDX-License-Identifier: MIT
// The enumerators of an enum, as known to the compiler, to check that a table of them is complete.
// In the signature of a template, g++ and clang++ print a number as the enumerator if there is one
// ("dsc::Integrator::rk4"), and as a cast ("(dsc::Integrator)9") if there is none.
#pragma once

#include "dsc/base/names.h"
#include "dsc/base/types.h"

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace dsc::test {

template <auto value>
constexpr std::string_view spelling() {
    const std::string_view signature = __PRETTY_FUNCTION__;
    const std::size_t begin = signature.find("value = ") + 8;
    return signature.substr(begin, signature.find_first_of(";]", begin) - begin);
}

/// The identifier of this enumerator; empty if the number is not one.
template <auto value>
constexpr std::string_view identifier() {
    const std::string_view text = spelling<value>();
    return text.starts_with('(') ? "" : text.substr(text.rfind(':') + 1);
}

/// The number of enumerators from 0 to 63.
template <class Enum>
constexpr std::size_t count_enumerators() {
    return []<std::size_t... number>(std::index_sequence<number...>) {
        return (std::size_t{!identifier<static_cast<Enum>(number)>().empty()} + ...);
    }
    (std::make_index_sequence<64>{});
}

/// The identifiers of all enumerators, of an enum whose numbers begin with 0.
template <class Enum>
std::vector<std::string_view> identifiers() {
    return []<std::size_t... number>(std::index_sequence<number...>) {
        return std::vector<std::string_view>{identifier<static_cast<Enum>(number)>()...};
    }
    (std::make_index_sequence<count_enumerators<Enum>()>{});
}

/// Each enumerator once, in order, and no two with the same name.
template <class Enum, std::size_t n>
constexpr bool is_complete(const EnumTable<Enum, n>& table) {
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (table[j].value >= table[i].value || table[j].name == table[i].name) {
                return false;
            }
        }
        if (table[i].name.empty()) {
            return false;
        }
    }
    return n == count_enumerators<Enum>();
}

} // namespace dsc::test
