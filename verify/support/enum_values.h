// SPDX-License-Identifier: MIT
// All values of an enum, for tests of each value.
#pragma once

#include "dsc/base/names.h"
#include "dsc/base/types.h"

namespace dsc::test {

/// The values without their names, in the order of the table.
template <class Enum, std::size_t n>
[[nodiscard]] constexpr std::array<Enum, n> values_in(const EnumTable<Enum, n>& table) {
    std::array<Enum, n> values{};
    for (std::size_t i = 0; i < n; ++i) {
        values[i] = table[i].value;
    }
    return values;
}

} // namespace dsc::test
